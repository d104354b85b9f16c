//! A file of a folder, written whole under a lock.

use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind, Write};
use std::path::PathBuf;

pub const FILE: &str = "progress.json";
pub const LOCK: &str = "progress.lock";

/// Keeps a text in a folder.
pub struct Store {
    folder: PathBuf,
}

impl Store {
    pub fn in_folder(folder: PathBuf) -> Self {
        Store { folder }
    }

    /// In the user's folder for the program's data. None where the system does not say where that is.
    pub fn of_user() -> Option<Self> {
        use etcetera::base_strategy::{BaseStrategy, choose_native_strategy};
        let base = choose_native_strategy().ok()?;
        Some(Store::in_folder(base.data_dir().join("lightwalk")))
    }

    /// What is kept; none where nothing is.
    pub fn read(&self) -> io::Result<Option<Vec<u8>>> {
        match fs::read(self.folder.join(FILE)) {
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
            text => text.map(Some),
        }
    }

    /// Until it is dropped, no other window writes. None while another one does.
    pub fn lock(&self) -> io::Result<Option<File>> {
        fs::create_dir_all(&self.folder)?;
        let lock = File::create(self.folder.join(LOCK))?;
        // A file system without locks must do without.
        let is_taken = matches!(lock.try_lock(), Err(TryLockError::WouldBlock));
        Ok((!is_taken).then_some(lock))
    }

    pub fn write(&self, text: &[u8]) -> io::Result<()> {
        let mut file = tempfile::Builder::new()
            .prefix(".progress-")
            .tempfile_in(&self.folder)?;
        file.write_all(text)?;
        file.persist(self.folder.join(FILE))
            .map_err(|error| error.error)?;
        Ok(())
    }

    /// Gives the file another name, which is returned.
    pub fn set_aside(&self) -> io::Result<String> {
        let named = |number: usize| self.folder.join(format!("progress.damaged-{number}.json"));
        let mut number = 1;
        while named(number).exists() {
            number += 1;
        }
        let aside = named(number);
        fs::rename(self.folder.join(FILE), &aside)?;
        Ok(aside.display().to_string())
    }
}
