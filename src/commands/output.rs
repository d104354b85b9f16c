//! Files that are written: they appear whole or not at all, and what is wrong with their names is reported before the work.

use super::failure::{Failure, unwritable};
use super::files::folder_of;
use super::interrupt;
use super::progress::Progress;
use crate::export::Making;
use std::fs;
use std::io::{BufWriter, Write};
use std::path::Path;

/// Finds fault with the name of an output file before any work is done.
pub fn check_output(path: &Path) -> Result<(), Failure> {
    let wrong = |why: &str| Failure::Wrong(format!("{}: {why}", path.display()));
    if path.is_dir() {
        return Err(wrong("is a folder; name a file"));
    }
    if !folder_of(path).is_dir() {
        return Err(wrong("its folder does not exist"));
    }
    if is_special(path) {
        return Ok(());
    }
    probe(&folder_of(path)).map_err(|why| wrong(&format!("cannot be written: {why}")))
}

/// Finds fault with an output file whose name ends in none of these.
pub fn check_ending(option: &str, path: &Path, allowed: &[&str]) -> Result<(), Failure> {
    let ending = path.extension().and_then(|ending| ending.to_str());
    match ending.is_some_and(|ending| allowed.contains(&ending)) {
        true => Ok(()),
        false => Err(Failure::Wrong(format!(
            "{option} {}: the name ends in .{}",
            path.display(),
            allowed.join(" or .")
        ))),
    }
}

/// Finds fault with an output file whose name has an ending, and none of these.
pub fn check_known_ending(option: &str, path: &Path, allowed: &[&str]) -> Result<(), Failure> {
    match path.extension() {
        Some(_) => check_ending(option, path, allowed),
        None => Ok(()),
    }
}

/// Finds fault with a folder for output, made or not made yet, before any work is done. Nothing is left in it.
pub fn check_output_folder(path: &Path) -> Result<(), Failure> {
    let wrong = |why: &str| Failure::Wrong(format!("--out {}: {why}", path.display()));
    let nearest = path.ancestors().find(|folder| folder.exists());
    let nearest = match nearest {
        Some(folder) if !folder.is_dir() => {
            return Err(wrong(&format!(
                "{} is a file; name a folder",
                folder.display()
            )));
        }
        Some(folder) => folder,
        None => Path::new("."),
    };
    probe(nearest).map_err(|why| wrong(&why))
}

/// Writes a file beside its place, then puts it there under its name. A device or a pipe stays what it is, and takes what is written
/// as it comes.
pub fn write_whole(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
) -> Result<(), Failure> {
    let failed = |error: std::io::Error| match error.kind() {
        std::io::ErrorKind::BrokenPipe => Failure::ReaderGone,
        _ => Failure::Failed(format!(
            "cannot write {}: {}",
            path.display(),
            unwritable(&error)
        )),
    };
    if is_special(path) {
        let device = fs::OpenOptions::new().write(true).open(path);
        let mut writer = BufWriter::new(device.map_err(failed)?);
        return write(&mut writer)
            .and_then(|()| writer.flush())
            .map_err(failed);
    }
    let mut builder = tempfile::Builder::new();
    // As readable as any new file; temporary files are private otherwise.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.prefix(".lightwalk-");
    interrupt::guard(
        || builder.tempfile_in(folder_of(path)).map_err(failed),
        |file| {
            let mut writer = BufWriter::new(file);
            write(&mut writer).map_err(failed)?;
            writer
                .into_inner()
                .map_err(|error| failed(error.into_error()))
        },
        |file| {
            file.persist(path)
                .map(drop)
                .map_err(|error| failed(error.error))
        },
    )
}

/// Writes what is made part by part, and says what that is where it takes long.
pub fn write_made(path: &Path, what: &'static str, making: Making) -> Result<(), Failure> {
    let progress = Progress::new(what);
    write_whole(path, |out| {
        making.write_all(out, &|done, all| progress.show(done, all))
    })
}

/// Makes a file in the folder, and takes it away again.
fn probe(folder: &Path) -> Result<(), String> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".lightwalk-");
    let probe = interrupt::whole(|| builder.tempfile_in(folder).map(drop));
    probe.map_err(|error| unwritable(&error))
}

/// Whether what stands there is a device or a pipe.
fn is_special(path: &Path) -> bool {
    path.metadata()
        .is_ok_and(|there| !there.is_file() && !there.is_dir())
}
