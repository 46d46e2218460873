//! scipy, in a Python process that takes one request a line (see `scipy_peer.py`) and times itself, so that it takes its
//! turn in every round like everybody else. Numbers travel as raw doubles in temporary files.

use crate::Result;
use crate::accuracy::{Case, ORDERS};
use crate::contender::Contender;
use std::cell::RefCell;
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::Duration;

/// The work that the script knows.
#[derive(Clone, Copy)]
pub(crate) enum Task {
    Cubic,
    Interpolate,
    Evaluate,
}

impl Task {
    /// By its name in the script.
    fn name(self) -> &'static str {
        match self {
            Task::Cubic => "CubicSpline",
            Task::Interpolate => "make_interp_spline",
            Task::Evaluate => "BSpline",
        }
    }

    fn label(self) -> &'static str {
        match self {
            Task::Cubic => "scipy CubicSpline",
            Task::Interpolate => "scipy make_interp_spline",
            Task::Evaluate => "scipy BSpline",
        }
    }
}

pub(crate) struct Scipy {
    child: Child,
    requests: ChildStdin,
    answers: BufReader<ChildStdout>,
    versions: String,
    folder: PathBuf,
}

impl Scipy {
    /// Starts the script on one thread, with the kernel that numpy's own libraries choose.
    pub(crate) fn start() -> Result<Scipy> {
        let folder = std::env::temp_dir().join(format!("lath-bench-{}", std::process::id()));
        let mut child = Command::new("python3")
            .arg(concat!(env!("CARGO_MANIFEST_DIR"), "/scipy_peer.py"))
            .env("OPENBLAS_NUM_THREADS", "1")
            .env("OMP_NUM_THREADS", "1")
            .env_remove("OPENBLAS_CORETYPE")
            .env_remove("OPENBLAS_L2_SIZE")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| format!("python3 cannot be started: {error}"))?;
        let requests = child.stdin.take().ok_or("python3 has no input")?;
        let answers = BufReader::new(child.stdout.take().ok_or("python3 has no output")?);
        fs::create_dir_all(&folder)?;
        let mut scipy = Scipy { child, requests, answers, versions: String::new(), folder };
        scipy.versions = scipy.answer()?;
        Ok(scipy)
    }

    pub(crate) fn versions(&self) -> &str {
        &self.versions
    }

    /// Hands over the lists of numbers that the next tasks work on: abscissae, points, parameters.
    pub(crate) fn load(&mut self, lists: &[&[f64]]) -> Result<()> {
        let path = self.write(lists)?;
        self.ask(&format!("load {path}"))?;
        Ok(())
    }

    /// Value and derivatives of a B-spline at the parameters of a case, order by order.
    pub(crate) fn answers(&mut self, case: &Case) -> Result<Vec<Vec<f64>>> {
        let numbers = [case.degree as f64, ORDERS as f64];
        let input = self.write(&[&numbers, &case.knots, &case.points, &case.parameters])?;
        let output = self.folder.join("answers");
        self.ask(&format!("answer {input} {}", output.display()))?;
        Ok(read(&output)?.chunks(case.parameters.len()).map(<[f64]>::to_vec).collect())
    }

    /// Writes lists to a file, each as its length and its values; where it is.
    fn write(&self, lists: &[&[f64]]) -> Result<String> {
        let mut bytes = Vec::new();
        for list in lists {
            bytes.extend((list.len() as f64).to_le_bytes());
            bytes.extend(list.iter().flat_map(|x| x.to_le_bytes()));
        }
        let path = self.folder.join("input");
        fs::write(&path, bytes)?;
        Ok(path.display().to_string())
    }

    pub(crate) fn contender(scipy: &RefCell<Scipy>, task: Task) -> Contender<'_> {
        let sample = move || scipy.borrow_mut().sample(task);
        let run = move || {
            let seconds: f64 = scipy.borrow_mut().ask(&format!("run {}", task.name()))?.parse()?;
            Ok(Duration::try_from_secs_f64(seconds)?)
        };
        Contender { name: task.label(), here: false, sample: Some(Box::new(sample)), run: Box::new(run) }
    }

    fn sample(&mut self, task: Task) -> Result<Vec<[f64; 3]>> {
        let path = self.folder.join("sample");
        self.ask(&format!("sample {} {}", task.name(), path.display()))?;
        Ok(read(&path)?.as_chunks().0.to_vec())
    }

    fn ask(&mut self, request: &str) -> Result<String> {
        writeln!(self.requests, "{request}")?;
        self.answer()
    }

    /// One line: `ok …` or the reason why not.
    fn answer(&mut self) -> Result<String> {
        let mut line = String::new();
        self.answers.read_line(&mut line)?;
        match line.trim_end_matches(['\r', '\n']).split_once(' ') {
            Some(("ok", rest)) => Ok(rest.to_owned()),
            _ if line.is_empty() => Err("python3 ended".into()),
            _ => Err(line.trim_end().into()),
        }
    }
}

/// A file of doubles.
fn read(path: &Path) -> Result<Vec<f64>> {
    Ok(fs::read(path)?.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect())
}

impl Drop for Scipy {
    fn drop(&mut self) {
        // Nothing to be done about failures here: the process may be gone, and the folder is temporary.
        let _ = self.child.kill();
        let _ = self.child.wait();
        let _ = fs::remove_dir_all(&self.folder);
    }
}
