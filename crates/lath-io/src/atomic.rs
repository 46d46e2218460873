//! Files written whole or not at all.
//!
//! The content goes to a new file in the same folder, which then takes the place of the old one in a single step;
//! whoever reads meanwhile, or whatever fails, finds the old file untouched. The permissions of a replaced file are
//! kept (its other hard links keep the old content). A symbolic link stays one, and the file it leads to is replaced.
//! Devices and pipes, and everything under `/dev` and `/proc`, are written directly.

use std::fs::{self, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::error::{Code, Error, Result};

/// How many symbolic links may lead from one to the next.
const MAX_LINKS: usize = 40;

/// Writes a file whole or not at all: `fill` writes the content.
///
/// ```
/// use lath_io::{Error, atomic};
///
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("out.txt");
/// atomic::write(&path, |out| out.write_all(b"one\n").map_err(|e| Error::writing(&e)))?;
/// assert_eq!(std::fs::read_to_string(&path)?, "one\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// What `fill` returns; I001 where the folder is missing, I002 where it or a file to be replaced may not be written,
/// I003 where the path is a folder, I005 other faults of the system. The file is then as it was.
pub fn write(path: impl AsRef<Path>, fill: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    let path = path.as_ref();
    write_to(path, fill).map_err(|error| error.in_source(&path.display().to_string()))
}

/// True where [`write()`] makes or replaces a file, whole or not at all; false for devices and pipes, where what has been
/// written stays written.
///
/// ```
/// use lath_io::atomic;
///
/// assert!(atomic::replaces("no-such-file.csv"));
/// # #[cfg(unix)]
/// assert!(!atomic::replaces("/dev/null"));
/// ```
#[must_use]
pub fn replaces(path: impl AsRef<Path>) -> bool {
    let path = path.as_ref();
    fs::metadata(path).map_or(true, |existing| existing.is_file() && !is_system(path))
}

/// Writes these bytes as a file, whole or not at all.
///
/// # Errors
/// As [`write()`].
pub fn write_bytes(path: impl AsRef<Path>, bytes: &[u8]) -> Result<()> {
    write(path, |out| out.write_all(bytes).map_err(|e| Error::writing(&e)))
}

fn write_to(path: &Path, fill: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    // The system follows the links here, also those of /proc that lead to no path.
    let existing = match fs::metadata(path) {
        Ok(existing) => Some(existing),
        Err(error) if error.kind() == io::ErrorKind::NotFound => None,
        Err(error) => return Err(Error::writing(&error)),
    };
    match existing {
        Some(about) if about.is_dir() => Err(Error::new(Code::I003, "this is a folder; a file cannot replace it")),
        Some(about) if !about.is_file() || is_system(path) => directly(path, fill),
        Some(about) if about.permissions().readonly() => {
            Err(Error::new(Code::I002, "the file is there and may not be written"))
        }
        other => replacing(&behind_links(path)?, other.map(|about| about.permissions()), fill),
    }
}

/// The file a chain of symbolic links leads to, which need not be there yet.
fn behind_links(path: &Path) -> Result<PathBuf> {
    let mut target = path.to_owned();
    for _ in 0..MAX_LINKS {
        match fs::read_link(&target) {
            Ok(next) => target = target.parent().unwrap_or(Path::new("")).join(next),
            Err(_) => return Ok(target), // no link, or nothing there
        }
    }
    Err(Error::new(Code::I005, "too many symbolic links, one leading to the next"))
}

/// Names like `/dev/stdout` may lead to a file that somebody else has open.
fn is_system(path: &Path) -> bool {
    path.starts_with("/dev") || path.starts_with("/proc")
}

fn directly(path: &Path, fill: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    let file = OpenOptions::new().append(true).open(path).map_err(|e| Error::writing(&e))?;
    let mut out = BufWriter::new(file);
    fill(&mut out)?;
    out.flush().map_err(|e| Error::writing(&e))
}

fn replacing(
    target: &Path,
    permissions: Option<fs::Permissions>,
    fill: impl FnOnce(&mut dyn Write) -> Result<()>,
) -> Result<()> {
    let folder = target.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let new = create(folder).map_err(|e| match e.kind() {
        io::ErrorKind::NotFound => Error::new(Code::I001, format!("there is no folder {}", folder.display())),
        io::ErrorKind::NotADirectory => Error::new(Code::I001, format!("{} is not a folder", folder.display())),
        _ => Error::writing(&e),
    })?;
    let mut out = BufWriter::new(new);
    fill(&mut out)?;
    let new = out.into_inner().map_err(|e| Error::writing(e.error()))?;
    if let Some(permissions) = permissions {
        new.as_file().set_permissions(permissions).map_err(|e| Error::writing(&e))?;
    }
    // On the disk before it takes the name: otherwise a power cut could leave an empty file under it.
    new.as_file().sync_all().map_err(|e| Error::writing(&e))?;
    new.persist(target).map(|_| ()).map_err(|e| Error::writing(&e.error))
}

#[cfg(unix)]
fn create(folder: &Path) -> io::Result<tempfile::NamedTempFile> {
    use std::os::unix::fs::PermissionsExt;
    // As any new file: what the process's mask leaves of this. Temporary files are private otherwise.
    let permissions = fs::Permissions::from_mode(0o666);
    tempfile::Builder::new().prefix(".lath-").permissions(permissions).tempfile_in(folder)
}

#[cfg(not(unix))]
fn create(folder: &Path) -> io::Result<tempfile::NamedTempFile> {
    tempfile::Builder::new().prefix(".lath-").tempfile_in(folder)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }

    #[test]
    fn files_are_made_and_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        write_bytes(&path, b"one").unwrap();
        write_bytes(&path, b"two").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(names(folder.path()), ["a.txt"]);
    }

    #[test]
    fn a_failure_leaves_the_old_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        write_bytes(&path, b"old").unwrap();
        let error = write(&path, |out| {
            out.write_all(&vec![b'x'; 100_000]).map_err(|e| Error::writing(&e))?;
            Err(Error::new(Code::F001, "stopped"))
        });
        assert_eq!(
            error.unwrap_err().to_string(),
            format!("{}: F001: stopped. Give at least one row of numbers.", path.display())
        );
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(names(folder.path()), ["a.txt"]);
    }

    #[test]
    fn what_cannot_be_written_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let code = |path: &Path| write_bytes(path, b"x").unwrap_err().code().as_str().to_owned();
        assert_eq!(code(folder.path()), "I003");
        assert_eq!(code(&folder.path().join("no/such/folder.txt")), "I001");
        let file = folder.path().join("file");
        write_bytes(&file, b"x").unwrap();
        assert!(code(&file.join("below")).starts_with('I'));
        let mut permissions = fs::metadata(&file).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&file, permissions).unwrap();
        assert_eq!(code(&file), "I002");
        assert_eq!(names(folder.path()), ["file"]);
    }

    #[cfg(unix)]
    #[test]
    fn permissions_are_kept_and_new_files_are_ordinary() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
        let (path, plain) = (folder.path().join("a"), folder.path().join("b"));
        fs::write(&plain, "").unwrap();
        write_bytes(&path, b"one").unwrap();
        assert_eq!(mode(&path), mode(&plain));
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
        write_bytes(&path, b"two").unwrap();
        assert_eq!(mode(&path), 0o640);
    }

    #[cfg(unix)]
    #[test]
    fn links_are_written_through() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("sub")).unwrap();
        fs::write(at("sub/real"), "old").unwrap();
        symlink("sub/real", at("link")).unwrap();
        symlink("link", at("link2")).unwrap();
        symlink("sub/fresh", at("dangling")).unwrap();
        write_bytes(at("link2"), b"new").unwrap();
        write_bytes(at("dangling"), b"made").unwrap();
        assert_eq!(
            (fs::read(at("sub/real")).unwrap(), fs::read(at("sub/fresh")).unwrap()),
            (b"new".to_vec(), b"made".to_vec())
        );
        assert!(["link", "link2", "dangling"].iter().all(|name| fs::symlink_metadata(at(name)).unwrap().is_symlink()));
        symlink("round", at("round")).unwrap();
        assert_eq!(write_bytes(at("round"), b"x").unwrap_err().code().as_str(), "I005");
    }

    #[cfg(unix)]
    #[test]
    fn devices_are_written_directly() {
        use std::os::unix::fs::FileTypeExt;
        write_bytes("/dev/null", b"gone").unwrap();
        assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
        let (mut reader, writer) = io::pipe().unwrap();
        let path = format!("/dev/fd/{}", std::os::fd::AsRawFd::as_raw_fd(&writer));
        if Path::new(&path).exists() {
            write_bytes(&path, b"through the pipe").unwrap();
            drop(writer);
            let mut text = String::new();
            io::Read::read_to_string(&mut reader, &mut text).unwrap();
            assert_eq!(text, "through the pipe");
        }
        let error = write_bytes("/dev/full", b"x");
        // Not on every system there; where it is, the disk is full.
        if Path::new("/dev/full").exists() {
            assert_eq!(error.unwrap_err().code().as_str(), "I005");
        }
    }
}
