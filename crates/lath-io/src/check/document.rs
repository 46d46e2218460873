//! Findings in JSON: shapes one by one, or a table.

use lath::error::Limits;

use crate::check::finding::Findings;
use crate::check::{Report, geometry, members, table};
use crate::error::{Code, Error, Result};
use crate::json::{self, Json, child};
use crate::points;
use crate::shapes::{self, Shape, geomdl, scipy};
use crate::source::Source;

pub(super) fn check(
    source: &Source,
    limits: &Limits<'_>,
    findings: &mut Findings<'_>,
    report: &mut Report,
) -> Result<()> {
    let tree = match json::parse(source, limits) {
        Ok(tree) => tree,
        Err(error) => return findings.push(error),
    };
    if shapes::recognise(&tree) {
        return document(tree, limits, findings, report);
    }
    report.points = Some(0);
    let foreign = if geomdl::recognise(&tree) {
        geomdl::from_tree(source, tree, limits)
    } else if scipy::recognise(&tree) {
        scipy::from_tree(source, tree, limits)
    } else {
        report.points = None;
        return match points::json::from_tree(source, tree, None, limits) {
            Ok(points) => table::table(&points, findings, report),
            Err(error) => findings.push(error),
        };
    };
    match foreign {
        Ok(shapes) => {
            report.shapes = Some(shapes.len());
            shapes.iter().try_for_each(|shape| curve(shape, "", findings))
        }
        Err(error) => findings.push(error),
    }
}

/// Lath JSON.
fn document(tree: Json, limits: &Limits<'_>, findings: &mut Findings<'_>, report: &mut Report) -> Result<()> {
    let list = match shapes::list(tree) {
        Ok(list) => list,
        Err(error) => return findings.push(error),
    };
    if list.is_empty() {
        findings.push(Error::new(Code::W017, "the file holds no shapes").at_pointer("/shapes"))?;
    }
    report.shapes = Some(list.len());
    let mut points = 0;
    for (index, tree) in list.into_iter().enumerate() {
        let pointer = child("/shapes", &index.to_string());
        let mut errors = Vec::new();
        members::check(&tree, &pointer, &mut |error: Error| {
            errors.push(error.code().as_str());
            findings.push(error)
        })?;
        // The reader has the last word: what it refuses is an error, also where nothing was found.
        match shapes::shape(index, tree, limits, &mut points) {
            Ok(shape) => curve(&shape, &pointer, findings)?,
            Err(error) if errors.contains(&error.code().as_str()) => {}
            Err(error) => findings.push(error)?,
        }
    }
    report.points = Some(usize::try_from(points).unwrap_or(usize::MAX));
    Ok(())
}

fn curve(shape: &Shape, pointer: &str, findings: &mut Findings<'_>) -> Result<()> {
    match shape.curve() {
        Some(curve) => geometry::check(curve, pointer, findings),
        None => Ok(()),
    }
}
