//! Room for the points of one triangle: on the stack for the degrees that occur, on the heap beyond.

use crate::num::Scalar;
use crate::space::Vector;
use alloc::vec::Vec;

/// Triangles of up to this many points need no allocation.
const ROOM: usize = 8;

/// A copy of some points, to be overwritten.
#[derive(Clone)]
pub(crate) struct Scratch<V> {
    stack: [V; ROOM],
    heap: Vec<V>,
    len: usize,
}

impl<V: Clone> Scratch<V> {
    /// A copy of the points.
    pub(crate) fn of<S: Scalar>(points: &[V]) -> Scratch<V>
    where
        V: Vector<S>,
    {
        let len = points.len();
        let fits = len <= ROOM;
        Scratch {
            stack: core::array::from_fn(|i| if fits && i < len { points[i].clone() } else { V::zero() }),
            heap: if fits { Vec::new() } else { points.to_vec() },
            len,
        }
    }

    /// The points that are left.
    pub(crate) fn points(&mut self) -> &mut [V] {
        if self.heap.is_empty() { &mut self.stack[..self.len] } else { &mut self.heap[..self.len] }
    }

    /// Forgets all but the first `len` points.
    pub(crate) fn shorten(&mut self, len: usize) {
        self.len = if len < self.len { len } else { self.len };
    }
}
