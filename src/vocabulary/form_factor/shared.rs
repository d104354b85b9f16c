//! Formulas, conditions and reasons that several kinds of steps share.

use crate::vocabulary::entry::{Formula, When, is};

pub(super) const BY_DISTANCE: &[Formula] = &[
    is("{d=distance} = |C_j − C_i|"),
    is("{R_i=radius_i} = 'max |P_k − C_i|'").unevaluated(FARTHEST),
    is("{R_j=radius_j} = 'max |P_k − C_j|'").unevaluated(FARTHEST),
];
pub(super) const FARTHEST: &str = "the largest of the distances to the corners";
pub(super) const PIECE: &str = "the corners of a part of a patch are not recorded";
/// Patch i, or j, faces the other one as a whole.
pub(super) const WHOLE_I: When = When::Known("corners_of_i");
pub(super) const WHOLE_J: When = When::Known("corners_of_j");
/// An edge that does not point at x.
pub(super) const SPANS: When = When::Not(&When::Zero("Gamma_k"));
pub(super) const INTEGRAL: &str = "an integral";
/// The pieces of the two patches have sums.
pub(super) const SUMMED: When = When::All(&[When::Not(&ADAPTIVE), When::Known("{sum/Pieces}")]);
/// Nothing was summed up, as nothing passes between the patches.
pub(super) const UNSUMMED: When = When::All(&[When::Not(&ADAPTIVE), When::Not(&SUMMED)]);
pub(super) const PARTS: &str = "each part of the patch begins a sum of its own";
/// The smaller patch is divided further and further.
pub(super) const ADAPTIVE: When = When::Equals("points", 0);
pub(super) const EDGES: &[Formula] = &[
    is("I = '∫∫ ln r ds dt'").unevaluated(INTEGRAL),
    is("{A_i F_{ij}=sum} = {(A_i F_{ij})_{old}=sum<0/Pieces} + 'L^2' [e_dot_f · I; 2π]")
        .unevaluated("the extent L is not recorded"),
];
pub(super) const RAY: &[Formula] = &[is("x"), is("{u=direction}"), is("hits")];
pub(super) const ACROSS: &str = "{u=u_pixel} := 2 ({x=pixel_x} + 0.5) / {n=resolution} − 1";
pub(super) const ALONG: &str = "{v=v_pixel} := 2 ({y=pixel_y} + 0.5) / {n=resolution} − 1";
pub(super) const AREA: &str = "{ΔA=pixel_area} := ([2; {n=resolution}])^2";
pub(super) const SUM_OF_PIXELS: &str = "F_x = {F_{x,old}=F_x<0} + delta_F";
pub(super) const SIGHT: &[Formula] = &[is("{V_{ij}=share} = ['Σ K V(x, y)'; 'Σ K']")
    .unevaluated("what single lines of sight would carry is not recorded")];
pub(super) const SEEN_FROM: &[Formula] = &[is("x"), is("F_x"), is("F_visible")];
