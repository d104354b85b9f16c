//! What a walk through a hierarchy has still to visit.

/// A node or leaf, and where the ray enters its box.
type Entry = (u32, f32);

/// Deep enough for a well-made hierarchy of many million boxes.
const SHORT: usize = 96;

/// A stack that takes no memory of its own until it is deeper than [`SHORT`].
pub(super) struct Stack {
    short: [Entry; SHORT],
    len: usize,
    /// What is beyond.
    deep: Vec<Entry>,
}

impl Stack {
    #[inline]
    pub fn new() -> Self {
        Stack {
            short: [(0, 0.0); SHORT],
            len: 0,
            deep: Vec::new(),
        }
    }

    pub fn len(&self) -> usize {
        self.len
    }

    #[inline]
    fn at(&mut self, index: usize) -> &mut Entry {
        if index < SHORT {
            &mut self.short[index]
        } else {
            &mut self.deep[index - SHORT]
        }
    }

    /// Puts an entry on top, but below those above `base` whose boxes are nearer.
    #[inline]
    pub fn push_below_nearer(&mut self, base: usize, entry: Entry) {
        if self.len >= SHORT {
            self.deep.push(entry);
        }
        let mut place = self.len;
        while place > base && self.at(place - 1).1 < entry.1 {
            *self.at(place) = *self.at(place - 1);
            place -= 1;
        }
        *self.at(place) = entry;
        self.len += 1;
    }

    /// The entry on top, if it is above `bottom`.
    #[inline]
    pub fn pop(&mut self, bottom: usize) -> Option<Entry> {
        if self.len == bottom {
            return None;
        }
        self.len -= 1;
        if self.len < SHORT {
            Some(self.short[self.len])
        } else {
            self.deep.pop()
        }
    }
}
