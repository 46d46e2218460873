//! Points as JSON.
//!
//! - `[[x,y],…]`: one array a point;
//! - `[x,…]`: points in one dimension;
//! - `{"columns":["x","y"],"rows":[[…],…]}`: what `eval` answers;
//! - `{"x":[…],"y":[…]}`: one array a column, all of one length.

use lath::error::{Code as CoreCode, Limits};

use crate::error::{Code, Error, Result};
use crate::json::{self, Json, Members, Rows, child, numbers, rows};
use crate::number::counted;
use crate::points::select::choose;
use crate::points::table::{PointTable, RowsAt};
use crate::source::Source;

/// The remedy for JSON that is something else.
const FORMS: &str = "Give points as [[x,y],…], columns as {\"x\":[…],\"y\":[…]}, or shapes as lath JSON.";

/// Reads points in JSON.
///
/// # Errors
/// F010 to F014 what is no JSON here, F015 to F017 members missing, unknown or of the wrong type, P001 no points, P005
/// rows or columns of different length, P006 rows without numbers; each with pointer, line and column. B001 above the
/// budget.
pub fn read(source: &Source, limits: &Limits<'_>) -> Result<PointTable> {
    let tree = json::parse(source, limits)?;
    from_tree(source, tree, None, limits)
}

/// The points of a tree; of the `wanted` columns only, where some are named, so that others may hold anything.
pub(crate) fn from_tree(
    source: &Source,
    tree: Json,
    wanted: Option<&[&str]>,
    limits: &Limits<'_>,
) -> Result<PointTable> {
    let mut table = match tree {
        Json::Object(_) if tree.has("rows") => named_rows(tree, wanted),
        Json::Object(members) => columns(members.into(), wanted),
        array => chosen_rows(array, "", None, wanted).map(|(rows, _)| table(rows, None, "")),
    }
    .map_err(|error| json::place(source, error))?;
    limits.check_points(table.len() as u64).map_err(|error| Error::from(error).in_source(source.name()))?;
    table.source = Some(source.name().to_owned());
    Ok(table)
}

fn table(rows: Rows, columns: Option<Vec<String>>, pointer: &str) -> PointTable {
    PointTable {
        source: None,
        title: None,
        columns,
        width: rows.width,
        values: rows.values,
        rows_at: RowsAt::Items(pointer.to_owned()),
    }
}

/// `{"columns": …, "rows": …}`
fn named_rows(tree: Json, wanted: Option<&[&str]>) -> Result<PointTable> {
    let mut members = Members::of(tree, "")?;
    let names = members.require("columns", "[\"x\",\"y\"]")?;
    let rows = members.require("rows", "[[x,y],…]")?;
    members.finish()?;
    let names = match names {
        Json::Array(names) => names.into(),
        other => vec![other],
    };
    let text = |(index, name): (usize, Json)| match name {
        Json::Text(name) => Ok(name.into()),
        other => {
            let message = format!("the name of column {index} is {}, not a string", other.type_name());
            Err(Error::new(Code::F017, message).at_pointer("/columns"))
        }
    };
    let names: Vec<String> = names.into_iter().enumerate().map(text).collect::<Result<_>>()?;
    let (rows, names) = chosen_rows(rows, "/rows", Some(names), wanted)?;
    Ok(table(rows, names, "/rows"))
}

/// The rows of the wanted columns with the names of those.
fn chosen_rows(
    array: Json,
    pointer: &str,
    names: Option<Vec<String>>,
    wanted: Option<&[&str]>,
) -> Result<(Rows, Option<Vec<String>>)> {
    let unnamed = |width: usize, names: &Option<Vec<String>>| match names {
        Some(names) if names.len() != width => {
            let message = format!("{} for rows of {width}", counted(names.len(), "name"));
            Err(Error::new(Code::Core(CoreCode::P005), message).at_pointer("/columns"))
        }
        _ => Ok(()),
    };
    let (Some(wanted), Json::Array(items)) = (wanted, &array) else {
        let rows = rows(array, pointer)?;
        unnamed(rows.width, &names)?;
        return match wanted {
            None => Ok((rows, names)),
            Some(wanted) => {
                let table = table(rows, names, pointer).take_columns(wanted)?;
                Ok((Rows { width: table.width, values: table.values }, table.columns))
            }
        };
    };
    let width_of = |row: &Json| match row {
        Json::Numbers(row) => Some(row.len()),
        Json::Array(row) => Some(row.len()),
        _ => None,
    };
    let width = items.first().and_then(width_of).unwrap_or(0);
    unnamed(width, &names)?;
    let picks = choose(names.as_deref(), width, wanted)?;
    let mut values = Vec::new();
    for (index, row) in items.iter().enumerate() {
        let here = || child(pointer, &index.to_string());
        match width_of(row) {
            Some(found) if found == width => {}
            Some(found) => {
                let message = format!("row {index} has {}, row 0 has {width}", counted(found, "value"));
                return Err(Error::new(Code::Core(CoreCode::P005), message).at_pointer(here()).at_index(index));
            }
            None => {
                let message = format!("row {index} is {}, not an array", row.type_name());
                return Err(Error::new(Code::F017, message).at_pointer(here()).at_index(index));
            }
        }
        for &pick in &picks {
            match row {
                Json::Numbers(row) => values.extend(row.get(pick)),
                Json::Array(row) => match row.get(pick) {
                    Some(Json::Number(value)) => values.push(*value),
                    other => {
                        let found = other.map_or("missing", Json::type_name);
                        let message = format!("column {pick} of row {index} is {found}, not a number");
                        let pointer = child(&here(), &pick.to_string());
                        return Err(Error::new(Code::F017, message).at_pointer(pointer).at_index(index));
                    }
                },
                _ => {}
            }
        }
    }
    let names = names.map(|names| picks.iter().filter_map(|&pick| names.get(pick).cloned()).collect());
    Ok((Rows { width: picks.len(), values }, names))
}

/// `{"x": …, "y": …}`
fn columns(mut members: Vec<(Box<str>, Json)>, wanted: Option<&[&str]>) -> Result<PointTable> {
    if let Some(wanted) = wanted {
        let all: Vec<String> = members.iter().map(|(name, _)| name.to_string()).collect();
        let picks = choose(Some(&all), all.len(), wanted)?;
        let mut index = 0;
        members.retain(|_| {
            index += 1;
            picks.contains(&(index - 1))
        });
        let names: Vec<&String> = picks.iter().filter_map(|&pick| all.get(pick)).collect();
        return columns(members, None)?.take_columns(&names);
    }
    let mut names: Vec<String> = Vec::new();
    let mut columns: Vec<Vec<f64>> = Vec::new();
    for (name, value) in members {
        let pointer = child("", &name);
        let column = numbers(value, &pointer).map_err(|error| error.remedied(FORMS))?;
        if let (Some(first), Some(first_name)) = (columns.first(), names.first())
            && first.len() != column.len()
        {
            let message = format!(
                "the column \"{name}\" has {}, \"{first_name}\" has {}",
                counted(column.len(), "number"),
                first.len()
            );
            return Err(Error::new(Code::Core(CoreCode::P005), message).at_pointer(pointer));
        }
        names.push(name.into());
        columns.push(column);
    }
    let length = columns.first().map_or(0, Vec::len);
    if length == 0 {
        return Err(Error::new(Code::Core(CoreCode::P001), "there are no points").at_pointer(""));
    }
    let values =
        (0..length).flat_map(|row| columns.iter().filter_map(move |column| column.get(row).copied())).collect();
    PointTable::new(Some(names), columns.len(), values)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(text: &str) -> PointTable {
        read(&Source::from_bytes("a.json", text), &Limits::default()).unwrap()
    }

    fn fault(text: &str) -> (&'static str, String, u64, u64) {
        let error = read(&Source::from_bytes("a.json", text), &Limits::default()).unwrap_err();
        let place = error.place().clone();
        assert_eq!(place.source.as_deref(), Some("a.json"));
        (error.code().as_str(), place.pointer.unwrap(), place.line.unwrap(), place.column.unwrap())
    }

    #[test]
    fn four_forms_are_read() {
        let t = table("[[1,2],[3,4]]");
        assert_eq!((t.width(), t.values(), t.columns()), (2, &[1.0, 2.0, 3.0, 4.0][..], None));
        assert_eq!((table("[1, 2.5, 3]").width(), table("[1, 2.5, 3]").len()), (1, 3));
        let named = table("{\"columns\":[\"t\",\"x\"],\"rows\":[[1,2],[3,4]]}");
        let columns = table("{\"t\":[1,3],\"x\":[2,4]}");
        assert_eq!((named.columns(), named.values()), (columns.columns(), columns.values()));
        assert_eq!(named.columns().unwrap(), ["t", "x"]);
    }

    #[test]
    fn faults_have_pointer_line_and_column() {
        assert_eq!(fault("[[1,2],\n [3]]"), ("P005", "/1".into(), 2, 2));
        assert_eq!(fault("[[1,2],\n [3,null]]"), ("F017", "/1/1".into(), 2, 5));
        assert_eq!(fault("[[1,2],\n 3]"), ("F017", "/1".into(), 2, 2));
        assert_eq!(fault("[1,[2]]"), ("F017", "/1".into(), 1, 4));
        assert_eq!(fault("[[[1,2]]]"), ("F017", "/0/0".into(), 1, 3));
        assert_eq!(fault("[]"), ("P001", "".into(), 1, 1));
        assert_eq!(fault("{}"), ("P001", "".into(), 1, 1));
        assert_eq!(fault("[[],[]]"), ("P006", "/0".into(), 1, 2));
        assert_eq!(fault("7"), ("F017", "".into(), 1, 1));
        assert_eq!(fault("{\"x\":[1],\n\"y\":[1,2]}"), ("P005", "/y".into(), 2, 5));
        assert_eq!(fault("{\"x\":[1],\"a/b\":\"c\"}"), ("F017", "/a~1b".into(), 1, 16));
        assert_eq!(fault("{\"rows\":[[1]]}"), ("F015", "".into(), 1, 1));
        assert_eq!(fault("{\"columns\":[\"x\"],\"rows\":[[1,2]]}"), ("P005", "/columns".into(), 1, 12));
        assert_eq!(fault("{\"columns\":[\"x\"],\"rows\":[[1]],\"z\":1}"), ("F016", "/z".into(), 1, 35));
        assert_eq!(fault("{\"columns\":[1],\"rows\":[[1]]}"), ("F017", "/columns".into(), 1, 12));
    }

    #[test]
    fn rows_can_be_placed_later() {
        let refused = |index| lath::error::Error::new(CoreCode::P004, "points coincide").at(index);
        let pointer = |t: &PointTable, index| t.locate(refused(index)).place().pointer.clone();
        assert_eq!(pointer(&table("[[1],[1]]"), 1).as_deref(), Some("/1"));
        assert_eq!(pointer(&table("{\"columns\":[\"x\"],\"rows\":[[1],[1]]}"), 1).as_deref(), Some("/rows/1"));
        assert_eq!(pointer(&table("[[1],[1]]"), 2), None);
        assert_eq!(pointer(&table("{\"x\":[1,1]}"), 1), None);
    }
}
