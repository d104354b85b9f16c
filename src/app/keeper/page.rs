//! The storage that a browser keeps for a page.

use std::io;

const KEY: &str = "lightwalk";

/// Keeps a text under a key of the storage.
pub struct Store {
    storage: web_sys::Storage,
}

impl Store {
    /// None where the browser keeps nothing, as in some private windows.
    pub fn of_user() -> Option<Self> {
        let storage = web_sys::window()?.local_storage().ok()??;
        Some(Store { storage })
    }

    /// What is kept; none where nothing is.
    pub fn read(&self) -> io::Result<Option<Vec<u8>>> {
        let text = self.storage.get_item(KEY);
        text.map(|text| text.map(String::into_bytes))
            .map_err(|_| refused())
    }

    /// A page is alone while it runs: others wait.
    pub fn lock(&self) -> io::Result<Option<()>> {
        Ok(Some(()))
    }

    pub fn write(&self, text: &[u8]) -> io::Result<()> {
        self.put(KEY, &String::from_utf8_lossy(text))
    }

    /// Moves the text to another key, which is returned.
    pub fn set_aside(&self) -> io::Result<String> {
        let text = self.storage.get_item(KEY).map_err(|_| refused())?;
        let aside = format!("{KEY}.damaged");
        self.put(&aside, &text.unwrap_or_default())?;
        self.storage.remove_item(KEY).map_err(|_| refused())?;
        Ok(aside)
    }

    fn put(&self, key: &str, text: &str) -> io::Result<()> {
        self.storage.set_item(key, text).map_err(|_| refused())
    }
}

fn refused() -> io::Error {
    io::ErrorKind::PermissionDenied.into()
}
