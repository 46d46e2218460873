//! What is counted of each contender, and the file that lets a stopped run go on.

use super::input::Family;
use super::oracle::ORDERS;
use crate::Result;
use std::fs;
use std::io::Write;
use std::path::PathBuf;

/// The answers of one contender to one question, by their E.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Tally {
    /// Answers that are numbers.
    pub(crate) answers: u64,
    /// NaN, an infinity, an error or a panic in place of an answer.
    pub(crate) none: u64,
    /// Questions about curves that it does not build.
    pub(crate) refused: u64,
    pub(crate) largest: f64,
    pub(crate) sum: f64,
}

impl Tally {
    pub(crate) fn add(&mut self, off: f64) {
        if off.is_finite() {
            self.answers += 1;
            self.largest = if off > self.largest { off } else { self.largest };
            self.sum += off;
        } else {
            self.none += 1;
        }
    }

    pub(crate) fn join(&mut self, other: &Tally) {
        self.answers += other.answers;
        self.none += other.none;
        self.refused += other.refused;
        self.largest = if other.largest > self.largest { other.largest } else { self.largest };
        self.sum += other.sum;
    }
}

/// One contender's tallies for value, first and second derivative.
pub(crate) type Tallies = [Tally; ORDERS];

/// Some cases of one degree and family, done: everybody's tallies in the order of the contenders.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Chunk {
    pub(crate) degree: usize,
    pub(crate) family: Family,
    pub(crate) number: usize,
    pub(crate) tallies: Vec<Tallies>,
}

impl Chunk {
    fn line(&self) -> String {
        let mut line = format!("{} {} {}", self.degree, self.family.name(), self.number);
        for tally in self.tallies.iter().flatten() {
            // Debug prints as many digits as it takes to read the same double again.
            line += &format!(" {} {} {} {:?} {:?}", tally.answers, tally.none, tally.refused, tally.largest, tally.sum);
        }
        line + "\n"
    }

    fn read(line: &str, contenders: usize) -> Option<Chunk> {
        let mut words = line.split(' ');
        let degree = words.next()?.parse().ok()?;
        let family = words.next()?;
        let family = Family::ALL.into_iter().find(|known| known.name() == family)?;
        let number = words.next()?.parse().ok()?;
        let mut tallies = vec![Tallies::default(); contenders];
        for tally in tallies.iter_mut().flatten() {
            *tally = Tally {
                answers: words.next()?.parse().ok()?,
                none: words.next()?.parse().ok()?,
                refused: words.next()?.parse().ok()?,
                largest: words.next()?.parse().ok()?,
                sum: words.next()?.parse().ok()?,
            };
        }
        words.next().is_none().then_some(Chunk { degree, family, number, tallies })
    }
}

/// The chunks that are done, in memory and, if a file was named, there.
pub(crate) struct Record {
    pub(crate) done: Vec<Chunk>,
    file: Option<fs::File>,
}

impl Record {
    /// Opens the file, or begins it. Its first line says what was run; a last line that was cut off is dropped.
    ///
    /// # Errors
    /// If the file belongs to another run, or holds anything else.
    pub(crate) fn open(path: Option<PathBuf>, run: &str, contenders: usize) -> Result<Record> {
        let Some(path) = path else { return Ok(Record { done: Vec::new(), file: None }) };
        let text = if path.exists() { fs::read_to_string(&path)? } else { String::new() };
        let whole = text.rfind('\n').map_or("", |end| &text[..=end]);
        let mut lines = whole.lines();
        let mut done = Vec::new();
        if let Some(first) = lines.next() {
            if first != run {
                return Err(format!("{} holds another run:\n  {first}\nnot\n  {run}", path.display()).into());
            }
            for (place, line) in lines.enumerate() {
                let chunk = Chunk::read(line, contenders);
                done.push(chunk.ok_or_else(|| format!("{}, line {}: no result", path.display(), place + 2))?);
            }
        }
        let mut file = fs::File::create(&path)?;
        file.write_all(if whole.is_empty() { format!("{run}\n") } else { whole.to_owned() }.as_bytes())?;
        Ok(Record { done, file: Some(file) })
    }

    pub(crate) fn holds(&self, degree: usize, family: Family, number: usize) -> bool {
        self.done.iter().any(|chunk| (chunk.degree, chunk.family, chunk.number) == (degree, family, number))
    }

    pub(crate) fn add(&mut self, chunk: Chunk) -> Result<()> {
        if let Some(file) = &mut self.file {
            file.write_all(chunk.line().as_bytes())?;
        }
        self.done.push(chunk);
        Ok(())
    }

    /// The tallies of one degree and family, joined in the order of the chunks, whenever they were done.
    pub(crate) fn joined(&self, degree: usize, family: Family, contenders: usize) -> Vec<Tallies> {
        let mut chunks: Vec<&Chunk> =
            self.done.iter().filter(|chunk| (chunk.degree, chunk.family) == (degree, family)).collect();
        chunks.sort_by_key(|chunk| chunk.number);
        let mut all = vec![Tallies::default(); contenders];
        for chunk in chunks {
            for (all, one) in all.iter_mut().flatten().zip(chunk.tallies.iter().flatten()) {
                all.join(one);
            }
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chunk(number: usize) -> Chunk {
        let mut tallies = vec![Tallies::default(); 2];
        tallies[1][2] = Tally { answers: 7, none: 1, refused: 500, largest: 1.0 / 3.0, sum: 1e300 };
        Chunk { degree: 3, family: Family::Wild, number, tallies }
    }

    #[test]
    fn a_cut_line_is_dropped_and_the_run_goes_on() {
        let path = std::env::temp_dir().join(format!("lath-accuracy-{}", std::process::id()));
        let open = |run: &str| Record::open(Some(path.clone()), run, 2);
        let mut record = open("a run").unwrap();
        record.add(chunk(0)).unwrap();
        record.add(chunk(1)).unwrap();
        drop(record);
        let text = fs::read_to_string(&path).unwrap();
        fs::write(&path, &text[..text.len() - 3]).unwrap();
        let mut record = open("a run").unwrap();
        assert_eq!(record.done, [chunk(0)]);
        record.add(chunk(1)).unwrap();
        drop(record);
        assert_eq!(fs::read_to_string(&path).unwrap(), text);
        assert!(open("another run").is_err());
        fs::remove_file(&path).unwrap();
    }
}
