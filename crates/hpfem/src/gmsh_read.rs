//! The two text and two binary dialects of gmsh mesh files, read into one plain table. Nothing here knows geometry; nothing panics.

use crate::gmsh_error::GmshError;
use std::collections::HashMap;
use std::rc::Rc;

/// Most physical groups one entity may be in. Every element of it is in all of them: without a bound a short file grows to any size.
const MOST_GROUPS: u64 = 100;

/// Physical tags of the geometric entities of MSH 4, by dimension and tag.
type Entities = HashMap<(i32, i32), Rc<[i32]>>;

/// What a file says: nodes, elements with their physical tags, names.
#[derive(Debug, Default)]
pub(crate) struct Tables {
    pub(crate) nodes: HashMap<u64, [f64; 3]>,
    pub(crate) elements: Vec<Element>,
    /// Names by dimension and physical tag.
    pub(crate) names: HashMap<(i32, i32), String>,
}

/// One element of the file.
#[derive(Debug)]
pub(crate) struct Element {
    pub(crate) tag: u64,
    pub(crate) kind: i32,
    /// Physical tags, which the elements of an entity share.
    pub(crate) physical: Rc<[i32]>,
    pub(crate) nodes: Vec<u64>,
}

/// Reads the sections of a file.
pub(crate) fn read(bytes: &[u8]) -> Result<Tables, GmshError> {
    let mut reader = Reader { bytes, at: 0, binary: false };
    let mut tables = Tables::default();
    let mut old = None;
    let mut entities = Entities::new();
    while let Some(section) = reader.section() {
        match (section.as_str(), old) {
            ("MeshFormat", _) => old = Some(format(&mut reader)?),
            ("PhysicalNames", _) => names(&mut reader, &mut tables)?,
            (_, None) => return Err(reader.fault("the file does not begin with $MeshFormat")),
            ("Entities", Some(false)) => entities = read_entities(&mut reader)?,
            ("Nodes", Some(false)) => nodes_4(&mut reader, &mut tables)?,
            ("Elements", Some(false)) => elements_4(&mut reader, &entities, &mut tables)?,
            ("Nodes", Some(true)) => nodes_2(&mut reader, &mut tables)?,
            ("Elements", Some(true)) => elements_2(&mut reader, &mut tables)?,
            _ => {}
        }
        reader.end_of(&section)?;
    }
    if old.is_none() {
        return Err(reader.fault("this is no gmsh file: it has no section $MeshFormat"));
    }
    Ok(tables)
}

/// Version and file type; true for version 2.
fn format(reader: &mut Reader<'_>) -> Result<bool, GmshError> {
    let version = reader.word()?;
    let old = match version.as_str() {
        "4.1" => false,
        "2" | "2.1" | "2.2" => true,
        _ => return Err(GmshError::Version { version }),
    };
    let binary = reader.word()? == "1";
    if reader.word()? != "8" {
        return Err(reader.fault("numbers are not of 8 bytes"));
    }
    if binary {
        reader.line_end();
        reader.binary = true;
        if reader.int()? != 1 {
            return Err(reader.fault("the file was written on a machine of the other byte order"));
        }
    }
    Ok(old)
}

fn names(reader: &mut Reader<'_>, tables: &mut Tables) -> Result<(), GmshError> {
    // Always text, in binary files too.
    let binary = std::mem::replace(&mut reader.binary, false);
    let count = reader.count()?;
    for _ in 0..count {
        let (dimension, tag) = (reader.int()?, reader.int()?);
        let name = reader.quoted()?;
        tables.names.insert((dimension, tag), name);
    }
    reader.binary = binary;
    Ok(())
}

fn read_entities(reader: &mut Reader<'_>) -> Result<Entities, GmshError> {
    let counts = [reader.count()?, reader.count()?, reader.count()?, reader.count()?];
    let mut entities = HashMap::new();
    for (dimension, count) in (0..).zip(counts) {
        for _ in 0..count {
            let tag = reader.int()?;
            for _ in 0..if dimension == 0 { 3 } else { 6 } {
                reader.double()?;
            }
            let physical = reader.count()?;
            if physical > MOST_GROUPS {
                return Err(reader.fault(&format!("an entity is in {physical} physical groups, of at most {MOST_GROUPS}")));
            }
            // Gmsh marks a reversed group by a negative tag.
            let tags = (0..physical).map(|_| reader.int().map(i32::wrapping_abs)).collect::<Result<Rc<[i32]>, _>>()?;
            if dimension > 0 {
                let bounding = reader.count()?;
                for _ in 0..bounding {
                    reader.int()?;
                }
            }
            entities.insert((dimension, tag), tags);
        }
    }
    Ok(entities)
}

fn nodes_4(reader: &mut Reader<'_>, tables: &mut Tables) -> Result<(), GmshError> {
    let blocks = reader.count()?;
    (0..3).try_for_each(|_| reader.count().map(|_| ()))?;
    for _ in 0..blocks {
        let dimension = reader.int()?;
        reader.int()?;
        let parametric = reader.int()? != 0;
        let count = reader.count()?;
        let tags = (0..count).map(|_| reader.count()).collect::<Result<Vec<u64>, _>>()?;
        for tag in tags {
            let x = [reader.double()?, reader.double()?, reader.double()?];
            for _ in 0..if parametric { dimension.clamp(0, 3) } else { 0 } {
                reader.double()?;
            }
            tables.nodes.insert(tag, x);
        }
    }
    Ok(())
}

fn elements_4(reader: &mut Reader<'_>, entities: &Entities, tables: &mut Tables) -> Result<(), GmshError> {
    let blocks = reader.count()?;
    (0..3).try_for_each(|_| reader.count().map(|_| ()))?;
    for _ in 0..blocks {
        let (dimension, entity, kind) = (reader.int()?, reader.int()?, reader.int()?);
        let count = reader.count()?;
        let physical = entities.get(&(dimension, entity)).cloned().unwrap_or_default();
        let size = node_count(kind)?;
        for _ in 0..count {
            let tag = reader.count()?;
            let nodes = (0..size).map(|_| reader.count()).collect::<Result<_, _>>()?;
            tables.elements.push(Element { tag, kind, physical: Rc::clone(&physical), nodes });
        }
    }
    Ok(())
}

fn nodes_2(reader: &mut Reader<'_>, tables: &mut Tables) -> Result<(), GmshError> {
    let count = reader.text_count()?;
    for _ in 0..count {
        let tag = reader.positive()?;
        let x = [reader.double()?, reader.double()?, reader.double()?];
        tables.nodes.insert(tag, x);
    }
    Ok(())
}

fn elements_2(reader: &mut Reader<'_>, tables: &mut Tables) -> Result<(), GmshError> {
    let count = reader.text_count()?;
    let mut done = 0;
    while done < count {
        // Text: one element a line, "tag kind tags.. nodes..". Binary: a header of kind, number of elements, number of tags.
        let (first, kind, following) = if reader.binary {
            let (kind, following) = (reader.int()?, reader.positive()?);
            (None, kind, following.max(1))
        } else {
            let tag = reader.positive()?;
            (Some(tag), reader.int()?, 1)
        };
        let tags = reader.positive()?;
        let size = node_count(kind)?;
        for _ in 0..following {
            let tag = match first {
                Some(tag) => tag,
                None => reader.positive()?,
            };
            // The first tag is the physical group, 0 for none.
            let mut physical = 0;
            for k in 0..tags {
                let tag = reader.int()?;
                physical = if k == 0 { tag.wrapping_abs() } else { physical };
            }
            let nodes = (0..size).map(|_| reader.positive()).collect::<Result<_, _>>()?;
            let physical = Some(physical).filter(|tag| *tag != 0).into_iter().collect();
            tables.elements.push(Element { tag, kind, physical, nodes });
        }
        done += following;
    }
    Ok(())
}

/// Number of nodes of an element type.
fn node_count(kind: i32) -> Result<usize, GmshError> {
    Ok(match kind {
        15 => 1,
        1 => 2,
        8 => 3,
        26 => 4,
        27 => 5,
        2 => 3,
        9 => 6,
        20 => 9,
        21 => 10,
        22 => 12,
        23 => 15,
        3 => 4,
        16 => 8,
        10 => 9,
        39 => 12,
        36 | 40 => 16,
        37 => 25,
        _ => return Err(GmshError::ElementType { kind }),
    })
}

/// Reads words or bytes, never beyond the end.
struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
    binary: bool,
}

impl Reader<'_> {
    fn fault(&self, reason: &str) -> GmshError {
        GmshError::Syntax { reason: reason.to_string(), byte: self.at }
    }

    /// The name of the next section.
    fn section(&mut self) -> Option<String> {
        while self.at < self.bytes.len() {
            if self.bytes[self.at] == b'$' {
                self.at += 1;
                let name = self.word().ok()?;
                self.line_end();
                return Some(name);
            }
            self.at += 1;
        }
        None
    }

    /// Goes behind `$EndName`; what is left of an unknown section is skipped.
    fn end_of(&mut self, name: &str) -> Result<(), GmshError> {
        let end = format!("$End{name}");
        let found = self.bytes[self.at..].windows(end.len()).position(|w| w == end.as_bytes());
        let found = found.ok_or_else(|| self.fault(&format!("the section ${name} has no end")))?;
        self.at += found + end.len();
        Ok(())
    }

    fn line_end(&mut self) {
        while self.at < self.bytes.len() {
            self.at += 1;
            if self.bytes[self.at - 1] == b'\n' {
                break;
            }
        }
    }

    fn word(&mut self) -> Result<String, GmshError> {
        while self.bytes.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
        let start = self.at;
        // Words end at white space; stop at the end of a line for line_end to see it.
        while self.bytes.get(self.at).is_some_and(|b| !b.is_ascii_whitespace()) {
            self.at += 1;
        }
        if start == self.at {
            return Err(self.fault("the file ends in the middle"));
        }
        Ok(String::from_utf8_lossy(&self.bytes[start..self.at]).into_owned())
    }

    fn quoted(&mut self) -> Result<String, GmshError> {
        let open = self.bytes[self.at..].iter().position(|b| *b == b'"').ok_or_else(|| self.fault("a name has no quotes"))?;
        let start = self.at + open + 1;
        let length =
            self.bytes[start..].iter().position(|b| *b == b'"').ok_or_else(|| self.fault("a name has no closing quote"))?;
        self.at = start + length + 1;
        Ok(String::from_utf8_lossy(&self.bytes[start..start + length]).into_owned())
    }

    fn raw<const N: usize>(&mut self) -> Result<[u8; N], GmshError> {
        let slice = self.at.checked_add(N).and_then(|end| self.bytes.get(self.at..end));
        let bytes = slice.and_then(|s| s.try_into().ok()).ok_or_else(|| self.fault("the file ends in the middle"))?;
        self.at += N;
        Ok(bytes)
    }

    fn parse<T: std::str::FromStr>(&mut self) -> Result<T, GmshError> {
        let word = self.word()?;
        word.parse().map_err(|_| self.fault(&format!("\"{}\" is no number", word.chars().take(40).collect::<String>())))
    }

    /// A 4-byte integer.
    fn int(&mut self) -> Result<i32, GmshError> {
        if self.binary { Ok(i32::from_le_bytes(self.raw()?)) } else { self.parse() }
    }

    /// A non-negative 4-byte integer.
    fn positive(&mut self) -> Result<u64, GmshError> {
        let value = if self.binary { i64::from(self.int()?) } else { self.parse()? };
        u64::try_from(value).map_err(|_| self.fault(&format!("{value} is negative")))
    }

    /// An 8-byte count or tag.
    fn count(&mut self) -> Result<u64, GmshError> {
        if self.binary { Ok(u64::from_le_bytes(self.raw()?)) } else { self.parse() }
    }

    /// A count that is text in binary files too, alone on its line (version 2).
    fn text_count(&mut self) -> Result<u64, GmshError> {
        let count = self.parse()?;
        self.line_end();
        Ok(count)
    }

    fn double(&mut self) -> Result<f64, GmshError> {
        if self.binary { Ok(f64::from_le_bytes(self.raw()?)) } else { self.parse() }
    }
}
