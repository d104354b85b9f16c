//! A list that only grows and changes in place, whose copies cost little: chunks are shared until they are written.

use std::sync::Arc;

/// Entries a chunk.
const CHUNK: usize = 64;

/// A copy costs a pointer for every 64 entries; the first write to a chunk that is shared copies it.
#[derive(Clone, Debug)]
pub struct CowVec<T> {
    chunks: Vec<Arc<Vec<T>>>,
    len: usize,
}

impl<T> Default for CowVec<T> {
    fn default() -> Self {
        CowVec {
            chunks: Vec::new(),
            len: 0,
        }
    }
}

impl<T: Clone> CowVec<T> {
    pub fn len(&self) -> usize {
        self.len
    }

    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    pub fn push(&mut self, entry: T) {
        if self.len.is_multiple_of(CHUNK) {
            self.chunks.push(Arc::new(Vec::with_capacity(CHUNK)));
        }
        if let Some(chunk) = self.chunks.last_mut() {
            Arc::make_mut(chunk).push(entry);
        }
        self.len += 1;
    }

    pub fn get(&self, index: usize) -> Option<&T> {
        self.chunks.get(index / CHUNK)?.get(index % CHUNK)
    }

    pub fn get_mut(&mut self, index: usize) -> Option<&mut T> {
        let chunk = self.chunks.get_mut(index / CHUNK)?;
        Arc::make_mut(chunk).get_mut(index % CHUNK)
    }

    pub fn iter(&self) -> impl Iterator<Item = &T> {
        self.chunks.iter().flat_map(|chunk| chunk.iter())
    }

    /// Bytes that keeping `self` takes when `before`, an earlier copy, is kept too.
    pub fn bytes_beyond(&self, before: &Self) -> usize {
        let shared = self
            .chunks
            .iter()
            .zip(&before.chunks)
            .filter(|(ours, theirs)| Arc::ptr_eq(ours, theirs))
            .count();
        let own = (self.chunks.len() - shared) * CHUNK * size_of::<T>();
        own + self.chunks.len() * size_of::<Arc<Vec<T>>>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn it_is_a_list_and_copies_stay_as_they_were(
            changes in prop::collection::vec((any::<bool>(), 0_usize..200, 0_u32..9), 0..400),
            copy_at in 0_usize..400,
        ) {
            let mut list = Vec::new();
            let mut grown = CowVec::default();
            let mut copies = None;
            for (i, (push, index, value)) in changes.into_iter().enumerate() {
                if i == copy_at {
                    copies = Some((list.clone(), grown.clone()));
                }
                if push {
                    list.push(value);
                    grown.push(value);
                } else {
                    prop_assert_eq!(list.get_mut(index).is_some(), grown.get_mut(index).is_some());
                    if let (Some(old), Some(new)) = (list.get_mut(index), grown.get_mut(index)) {
                        *old = value;
                        *new = value;
                    }
                }
            }
            prop_assert_eq!(grown.len(), list.len());
            prop_assert_eq!(grown.get(list.len()), None);
            prop_assert!(grown.iter().eq(&list));
            if let Some((list, grown)) = copies {
                prop_assert!(grown.iter().eq(&list));
            }
        }
    }

    #[test]
    fn a_copy_shares_what_was_not_written() {
        let mut grown = CowVec::default();
        (0..1000_u64).for_each(|i| grown.push(i));
        let before = grown.clone();
        assert_eq!(grown.bytes_beyond(&before), 16 * size_of::<usize>());
        *grown.get_mut(70).expect("there") = 0;
        assert_eq!(
            grown.bytes_beyond(&before),
            16 * size_of::<usize>() + CHUNK * size_of::<u64>()
        );
    }
}
