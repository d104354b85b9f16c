//! The panel's words.

use crate::language::Message;

pub(super) const NO_RAY: Message = Message("ray-tree-no-ray");
pub(super) const NO_RAYS: Message = Message("ray-tree-no-rays");
pub(super) const INSIDE: Message = Message("ray-tree-inside");
pub(super) const BACKGROUND: Message = Message("ray-tree-background");
pub(super) const LEAVES: Message = Message("ray-tree-leaves");
pub(super) const LEAVES_SHORT: Message = Message("ray-tree-leaves-short");
pub(super) const LIGHT_MET: Message = Message("ray-tree-light-met");
pub(super) const SEARCHING: Message = Message("ray-tree-searching");
pub(super) const NOT_TRACED: Message = Message("ray-tree-not-traced");
pub(super) const ASKED: Message = Message("ray-tree-asked");
pub(super) const NO_TRANSMITTED: Message = Message("ray-tree-no-transmitted");
pub(super) const DEPTH_REACHED: Message = Message("ray-tree-depth-reached");
pub(super) const NO_COEFFICIENT: Message = Message("ray-tree-no-coefficient");
pub(super) const TIR: Message = Message("common-total-internal-reflection");

pub(super) const RAYS: Message = Message("ray-tree-rays");
pub(super) const LEVEL: Message = Message("common-level");
pub(super) const LEVEL_OF: Message = Message("ray-tree-level");
pub(super) const HIDDEN: Message = Message("ray-tree-hidden");

pub(super) const SHADOW_RAYS: Message = Message("ray-tree-shadow-rays");
pub(super) const LIGHTS: Message = Message("ray-tree-lights");
pub(super) const COMING_BACK: Message = Message("ray-tree-coming-back");
pub(super) const BLOCKED: Message = Message("ray-tree-blocked");
pub(super) const BLOCKED_BY: Message = Message("ray-tree-blocked-by");
pub(super) const CLEAR: Message = Message("ray-tree-clear");
pub(super) const IS_BLOCKED: Message = Message("common-blocked");
pub(super) const IS_BLOCKED_BY: Message = Message("common-blocked-by");
pub(super) const IS_CLEAR: Message = Message("ray-tree-clear-at");
pub(super) const SO_FAR: Message = Message("ray-tree-so-far");
pub(super) const NEAREST: Message = Message("ray-tree-nearest");
pub(super) const TESTED: Message = Message("ray-tree-tested");
pub(super) const MISSED: Message = Message("ray-tree-missed");

/// Above what each level gave.
pub(super) const FROM_LEVEL: Message = Message("ray-tree-from-level");
/// In the place of light that has not come back.
pub(super) const NOT_KNOWN: &str = "—";

pub(super) const PINNED: Message = Message("ray-tree-pinned");
pub(super) const HERE: Message = Message("ray-tree-here");
pub(super) const BEFORE_CHANGE: Message = Message("ray-tree-before-change");
pub(super) const SAME: Message = Message("ray-tree-same");
pub(super) const DIFFERS: Message = Message("ray-tree-differs");
pub(super) const GOES_ON: Message = Message("ray-tree-goes-on");
