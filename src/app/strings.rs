//! The window's words, in both languages.

use crate::language::{Language, Message};
use crate::lesson::Chapter;
use crate::study::harness::Point;
use crate::study::report::strings as report;

pub const PRESENT: Message = Message("app-present");
pub const SHARE: Message = Message("app-share");
pub const SHARED: Message = Message("app-shared");
pub const TAKE_AWAY: Message = Message("app-take-away");
pub const COPY_PICTURE: Message = Message("app-copy-picture");
pub const COPIED: Message = Message("app-copied");
pub const TAKE_PINNED: Message = Message("app-take-pinned");
pub const TAKING: Message = Message("app-taking");
pub const TAKEN: Message = Message("app-taken");
pub const NOT_TAKEN: Message = Message("app-not-taken");
pub const THEME: Message = Message("app-theme");
pub const THEME_LIGHT: Message = Message("app-theme-light");
pub const THEME_DARK: Message = Message("app-theme-dark");
pub const THEME_PROJECTOR: Message = Message("app-theme-projector");
pub const KEYS: Message = Message("app-keys");
pub const KEYS_TITLE: Message = Message("app-keys-title");
pub const CLOSE: Message = Message("app-close");
pub const MENU: Message = Message("app-menu");
pub const MORE: Message = Message("app-more");
pub const RANGE: Message = Message("app-range");
pub const RANGE_OF_LENGTHS: Message = Message("app-range-of-lengths");
pub const LENGTHS: Message = Message("app-lengths");
pub const ALREADY_TRIED: Message = Message("app-already-tried");
pub const NOTHING_CHANGED: Message = Message("app-nothing-changed");
pub const AT_ITS_END: Message = Message("app-at-its-end");
pub const QUESTIONS: Message = Message("app-questions");
pub const STUDIES: Message = Message("app-studies");
pub const STUDY: Message = Message("app-study");
pub const QUICK: Message = Message("app-quick");
pub const MEASURE: Message = Message("app-measure");
pub const CALL_OFF: Message = Message("app-call-off");
pub const BACK_TO_THE_RUN: Message = Message("app-back-to-the-run");
pub const MEASURING: Message = Message("app-measuring");
pub const CALLED_OFF: Message = Message("app-called-off");
pub const NO_FINDINGS: Message = Message("app-no-findings");
pub const NOTHING_MEASURED: Message = Message("app-nothing-measured");
pub const DEBUG_BUILD: Message = Message("app-debug-build");
pub const STUDY_PLOT: Message = Message("app-study-plot");
pub const ON_THE_FRONT: Message = Message("app-on-the-front");
pub const MEMORY_IS: Message = Message("app-memory-is");
pub const ERROR_FALLS: Message = Message("app-law-of-error");
pub const TIME_GROWS: Message = Message("app-law-of-time");
pub const NO_LAW: Message = Message("app-no-law");
pub const CLICK_OPENS_IT: Message = Message("app-click-opens-it");
pub const MEASURED_AGAIN_BY: Message = Message("app-measured-again-by");
pub const REFERENCE: Message = Message("app-reference");
pub const PARETO: Message = Message("app-pareto");

pub const COMPARE: Message = Message("app-compare");
pub const COMPARISON: Message = Message("app-compare-title");
pub const COMPARE_HOW: Message = Message("app-compare-how");
pub const COMPARE_WHERE: Message = Message("app-compare-where");
pub const COMPARE_SIZE: Message = Message("app-compare-size");
pub const COMPARE_TOO_LARGE: Message = Message("app-compare-too-large");
pub const COMPARE_DRAWING: Message = Message("app-compare-drawing");
pub const COMPARE_TRYING: Message = Message("app-compare-trying");
pub const COMPARE_SIZE_IS: Message = Message("app-compare-size-is");
pub const COMPARE_LINEAR: Message = Message("app-compare-linear");
pub const COMPARE_EQUAL: Message = Message("app-compare-equal");
pub const COMPARE_OFF: Message = Message("app-compare-off");
pub const COMPARE_NO_MISTAKE: Message = Message("app-compare-no-mistake");
pub const COMPARE_EXPLAINS: Message = Message("app-compare-explains");
pub const COMPARE_MINE: Message = Message("app-compare-mine");
pub const COMPARE_REFERENCE: Message = Message("app-compare-reference");
pub const COMPARE_DIFFERENCE: Message = Message("app-compare-difference");
pub const COMPARE_WORST: Message = Message("app-compare-worst");
pub const COMPARE_PIXEL: Message = Message("app-compare-pixel");
pub const PICTURE_READ_AGAIN: Message = Message("app-picture-read-again");
pub const AFTER_YOUR_ANSWER: Message = Message("panels-after-your-answer");

pub const WHAT_IF: Message = Message("app-what-if");
pub const WHAT_IF_HERE: Message = Message("app-what-if-here");
pub const WHAT_IF_HOW: Message = Message("app-what-if-how");
pub const WHAT_IF_SHARE: Message = Message("app-what-if-share");
pub const WHAT_IF_UNCHANGED: Message = Message("app-what-if-unchanged");
pub const WHAT_IF_NO_DIFFERENCE: Message = Message("app-what-if-no-difference");
pub const WHAT_IF_ALL: Message = Message("app-what-if-all");
pub const WHAT_IF_NEXT: Message = Message("app-what-if-next");
pub const WHAT_IF_PREVIOUS: Message = Message("app-what-if-previous");
pub const WHAT_IF_DRAWING: Message = Message("app-what-if-drawing");
pub const WHAT_IF_WRONG: Message = Message("app-what-if-wrong");
pub const WHAT_IF_RIGHT: Message = Message("app-what-if-right");
pub const WHAT_IF_DIFFERENCE: Message = Message("app-what-if-difference");
pub const WHAT_IF_PIXEL: Message = Message("app-what-if-pixel");

pub const MISTAKES: Message = Message("app-mistakes");
pub const MISTAKES_HOW: Message = Message("app-mistakes-how");

pub const EDIT: Message = Message("app-edit");
pub const EDIT_A_SCENE: Message = Message("app-edit-a-scene");
pub const SCENE_WHOLE: Message = Message("app-scene-whole");
pub const SCENE_CAMERA: Message = Message("app-scene-camera");
pub const SCENE_MATERIALS: Message = Message("app-scene-materials");
pub const SCENE_OBJECTS: Message = Message("app-scene-objects");
pub const SCENE_LIGHTS: Message = Message("app-scene-lights");
pub const SCENE_ADD_TO: Message = Message("app-scene-add-to");
pub const SCENE_COPY: Message = Message("app-scene-copy");
pub const SCENE_DELETE: Message = Message("app-scene-delete");
pub const SCENE_LEAVE_OUT: Message = Message("app-scene-leave-out");
pub const SCENE_COLOR: Message = Message("app-scene-color");
pub const SCENE_AS_TEXT: Message = Message("app-scene-as-text");
pub const SCENE_TEXT: Message = Message("app-scene-text");
pub const SCENE_SAVE: Message = Message("app-scene-save");
pub const SCENE_IS_SAVED: Message = Message("app-scene-is-saved");
pub const SCENE_BACK: Message = Message("app-scene-back");
pub const SCENE_CONFLICT: Message = Message("app-scene-conflict");
pub const SCENE_TAKE_THEIRS: Message = Message("app-scene-take-theirs");
pub const SCENE_SAVE_MINE: Message = Message("app-scene-save-mine");

pub const LESSONS: Message = Message("app-lessons");
pub const CHAPTERS: [(Chapter, Message); 4] = [
    (Chapter::Shading, Message("app-chapter-shading")),
    (Chapter::RayTracing, Message("app-chapter-ray-tracing")),
    (Chapter::Radiosity, Message("app-chapter-radiosity")),
    (Chapter::Study, Message("app-chapter-study")),
];
pub const NEXT_LESSON: Message = Message("app-next-lesson");
pub const PREVIOUS_LESSON: Message = Message("app-previous-lesson");
pub const NO_NEXT_LESSON: Message = Message("app-no-next-lesson");
pub const NO_PREVIOUS_LESSON: Message = Message("app-no-previous-lesson");
pub const NOT_IN_THE_LIST: Message = Message("app-not-in-the-list");
pub const SEARCH_LESSONS: Message = Message("app-search-lessons");
pub const HAS_ERRORS: Message = Message("app-has-errors");
pub const NO_LESSON_FOUND: Message = Message("app-no-lesson-found");
pub const BEGIN: Message = Message("app-begin");
pub const CONTINUE: Message = Message("app-continue");
pub const EXPLANATIONS: Message = Message("app-explanations");
pub const EXPLANATION_OF: Message = Message("app-explanation-of");
pub const OPEN_FILE: Message = Message("app-open-file");
pub const OPEN_FOLDER: Message = Message("app-open-folder");
pub const OUTLINE: Message = Message("app-outline");
pub const OUTLINE_AT: Message = Message("app-outline-at");
pub const START_AGAIN: Message = Message("app-start-again");
pub const PREVIOUS_SAID: Message = Message("keys-explained-step-before");
pub const FINISH: Message = Message("app-finish");
pub const FINISHED: Message = Message("app-finished");
pub const LEARNED: Message = Message("app-learned");
pub const QUESTIONS_RIGHT: Message = Message("app-questions-right");
pub const LOOK_AGAIN: Message = Message("app-look-again");
pub const NEXT_LESSON_IS: Message = Message("app-next-lesson-is");
pub const NOT_ANSWERED: Message = Message("app-not-answered");
pub const ENTRY: Message = Message("app-entry");
pub const ENTRY_ASKS: Message = Message("app-entry-asks");
pub const SCORE: Message = Message("app-score");

pub const FORGET: Message = Message("app-forget");
pub const FORGET_WHAT: Message = Message("app-forget-what");
pub const FORGET_IT: Message = Message("app-forget-it");
pub const KEEP_IT: Message = Message("app-keep-it");
pub const SAVE_PROGRESS: Message = Message("app-save-progress");
pub const LOAD_PROGRESS: Message = Message("app-load-progress");
pub const PROGRESS_LOADED: Message = Message("app-progress-loaded");
pub const PROGRESS_DAMAGED: Message = Message("app-progress-damaged");
pub const PROGRESS_FOREIGN: Message = Message("app-progress-foreign");
pub const OWN_SCENES: Message = Message("app-own-scenes");
pub const FORGET_SCENE: Message = Message("app-forget-scene");
pub const KEPT_SET_ASIDE: Message = Message("app-kept-set-aside");
pub const NOT_KEPT: Message = Message("app-not-kept");

pub const TEXT_SIZE: Message = Message("app-text-size");
pub const TEXT_SIZE_TO: Message = Message("app-text-size-to");

pub const AT_THE_START_NAME: Message = Message("keys-first-step");
pub const PREVIOUS_SCOPE: Message = Message("keys-previous-scope");
pub const ONE_BACK: Message = Message("app-one-back");
pub const PLAY: Message = Message("keys-play-or-pause");
pub const ONE_ON: Message = Message("app-one-on");
pub const NEXT_SCOPE: Message = Message("keys-next-scope");
pub const SLOWER: Message = Message("keys-slower");
pub const FASTER: Message = Message("keys-faster");

pub const STEP_OF: Message = Message("app-step-of");
pub const STEPS_A_SECOND: Message = Message("app-steps-a-second");
pub const LOOP: Message = Message("app-loop");
pub const LOOP_OFF: Message = Message("app-loop-off");
pub const LOOP_FROM_HERE: Message = Message("app-loop-from-here");
pub const LOOP_TO_HERE: Message = Message("app-loop-to-here");
pub const RUN_TO: Message = Message("app-run-to");
pub const NEXT_OF_THIS_KIND: Message = Message("app-next-of-this-kind");
pub const SEARCH: Message = Message("app-search");
pub const SEARCH_HINT: Message = Message("app-search-hint");
pub const BREAKPOINT: Message = Message("app-breakpoint");
pub const TRUNCATED: Message = Message("app-truncated");

pub const MAKING_THE_PICTURE: Message = Message("app-making-the-picture");
pub const NOT_HAPPENING: Message = Message("app-not-happening");
pub const UNDO: Message = Message("app-undo");
pub const REDO: Message = Message("app-redo");
pub const NOTHING_TO_UNDO: Message = Message("app-nothing-to-undo");
pub const NOTHING_TO_REDO: Message = Message("app-nothing-to-redo");
pub const RANGE_IN: Message = Message("app-range-in");
pub const METHOD: Message = Message("app-method");
pub const METHOD_OF_THE_LESSON: Message = Message("app-method-of-the-lesson");
pub const METHOD_AS_IT_IS: Message = Message("app-method-as-it-is");
pub const READ_AGAIN: Message = Message("app-read-again");
pub const TYPED_NUMBERS: Message = Message("app-typed-numbers");
pub const UNSAID: Message = Message("app-unsaid");
pub const PUT_BACK: Message = Message("app-put-back");

pub const SLIDE: Message = Message("app-slide");
pub const NEXT_SAID: Message = Message("keys-next-explained-step");
pub const OTHER_FOCUS: Message = Message("app-other-focus");
pub const BACK_TO_LESSON: Message = Message("app-back-to-the-run");

pub const BEFORE_YOU_GO_ON: Message = Message("app-before-you-go-on");
pub const CHECK: Message = Message("app-check");
pub const ANSWER_WITH_A_KEY: Message = Message("app-answer-with-a-key");
pub const SKIP: Message = Message("app-skip");
pub const YOUR_ANSWER: Message = Message("app-your-answer");
pub const CLICK_A_PIXEL: Message = Message("app-click-a-pixel");
pub const MOVE_UP: Message = Message("app-move-up");
pub const MOVE_DOWN: Message = Message("app-move-down");
pub const CLICK_AN_OBJECT: Message = Message("app-click-an-object");
pub const CLICK_A_PATCH: Message = Message("app-click-a-patch");
pub const TURN_THE_ARROW: Message = Message("app-turn-the-arrow");
pub const ARROW_ANGLE: Message = Message("app-arrow-angle");
pub const UNDECIDED: Message = Message("app-undecided");
pub const LESSONS_VALUES: Message = Message("app-lessons-values");
pub const ANSWER_NOW: Message = Message("app-answer-now");
pub const ONCE_MORE: Message = Message("app-once-more");
pub const YOU_ANSWERED: Message = Message("app-you-answered");
pub const RIGHT: Message = Message("app-right");
pub const WRONG: Message = Message("app-wrong");
pub const SKIPPED: Message = Message("app-skipped");
pub const THE_ANSWER_IS: Message = Message("app-the-answer-is");
pub const SHOW_THE_STEP: Message = Message("app-show-the-step");

pub const LEFT_OUT: Message = Message("app-left-out");
pub const LEFT_OUT_ABOUT: Message = Message("app-left-out-about");
pub const NOTHING_LEFT_OUT: Message = Message("app-nothing-left-out");
pub const IS_NEEDED: Message = Message("app-is-needed");
pub const TIMES_MEASURED: Message = Message("app-times-measured");
pub const TIMES: Message = Message("app-times");
pub const TIMES_TIE: Message = Message("app-times-tie");
pub const TIMES_NONE: Message = Message("app-times-none");
pub const SHARE_AS_LEFT_OUT_ONLY: Message = Message("app-share-as-left-out-only");
pub const UNSAID_ANYWAY: Message = Message("app-unsaid-anyway");
pub const LEAVE_OUT_AGAIN: Message = Message("app-leave-out-again");
pub const UNSHOT: Message = Message("app-unshot");
pub const UNSHOT_ROOM: Message = Message("app-unshot-room");
pub const NO_UNSHOT: Message = Message("app-no-unshot");
pub const STEP_BY_STEP: Message = Message("app-step-by-step");
pub const FORM_FACTOR_BY_STEPS: Message = Message("app-form-factor-by-steps");
pub const FOLLOWED_ALREADY: Message = Message("app-followed-already");
pub const SMOOTH: Message = Message("app-smooth");
pub const SMOOTH_ROOM: Message = Message("app-smooth-room");
pub const FROM_OVERVIEW: Message = Message("app-from-overview");
pub const FROM_THE_EYE: Message = Message("app-from-the-eye");
pub const FROM_THE_SIDE: Message = Message("app-from-the-side");
pub const FROM_ABOVE: Message = Message("app-from-above");
pub const ACROSS_INCIDENCE: Message = Message("app-across-incidence");
pub const ALONG_THE_RAY: Message = Message("app-along-the-ray");
pub const WHICH_RAYS: Message = Message("app-which-rays");
pub const RAYS_OF_THE_PIXEL: Message = Message("app-rays-of-the-pixel");
pub const RAYS_OF_A_BLOCK: Message = Message("app-rays-of-a-block");
pub const RAYS_OF_A_ROW: Message = Message("app-rays-of-a-row");
pub const RAYS_OF_A_GRID: Message = Message("app-rays-of-a-grid");
pub const LEVELS: Message = Message("app-levels");
pub const ALL_LEVELS: Message = Message("app-all-levels");
pub const LARGER_SCENE: Message = Message("app-larger-scene");
pub const SMALLER_SCENE: Message = Message("app-smaller-scene");
pub const SPACE_AS_IT_IS: Message = Message("app-space-as-it-is");
pub const WHOLE_PICTURE: Message = Message("app-whole-picture");
pub const LARGER_PICTURE: Message = Message("app-larger-picture");
pub const SMALLER_PICTURE: Message = Message("app-smaller-picture");
pub const IMAGE_AS_IT_IS: Message = Message("app-image-as-it-is");
pub const SEARCH_VALUES: Message = Message("app-search-values");
pub const TREE_FIT: Message = Message("app-tree-fit");
pub const WHOLE_TREE: Message = Message("app-whole-tree");
pub const LARGER_TREE: Message = Message("app-larger-tree");
pub const SMALLER_TREE: Message = Message("app-smaller-tree");
pub const PIN: Message = Message("app-pin");
pub const UNPIN: Message = Message("app-unpin");
pub const PIN_TREE: Message = Message("app-pin-tree");
pub const UNPIN_TREE: Message = Message("app-unpin-tree");
pub const NOTHING_TO_PIN: Message = Message("app-nothing-to-pin");
pub const TREE_AS_IT_IS: Message = Message("app-tree-as-it-is");
pub const INSPECTOR: Message = Message("app-inspector");
pub const FILL: Message = Message("keys-fill");
pub const UNFILL: Message = Message("app-unfill");
pub const ENLARGE: Message = Message("app-enlarge");
pub const NO_SUCH_PANEL: Message = Message("app-no-such-panel");
pub const IS_KEY_PANEL: Message = Message("app-is-key-panel");
pub const NO_PARAMETERS: Message = Message("app-no-parameters");
pub const CLICK_A_ROW: Message = Message("app-click-a-row");

pub const DRAG: Message = Message("app-drag");
pub const VERTEX_OF: Message = Message("app-vertex-of");
pub const PARAMETERS: Message = Message("app-parameters");
pub const LIGHT: Message = Message("common-light");
pub const EYE: Message = Message("common-eye");
pub const AS_A_NUMBER: Message = Message("app-as-a-number");
pub const DISTANCE: Message = Message("app-distance");
pub const FROM_THE_TARGET: Message = Message("app-from-the-target");
pub const DIVISIONS: Message = Message("app-divisions");

pub const LINE: Message = Message("app-line");
pub const POLYGON: Message = Message("app-polygon");
pub const FRAME: Message = Message("app-frame");
pub const FOCUS_ON: Message = Message("app-focus-on");
pub const THE_LESSONS_PART: Message = Message("app-the-lessons-part");

pub const AT_THE_START: Message = Message("app-at-the-start");
pub const AT_THE_END: Message = Message("app-at-the-end");
pub const NO_SCOPE_AHEAD: Message = Message("app-no-scope-ahead");
pub const NO_SCOPE_BEFORE: Message = Message("app-no-scope-before");
pub const NOTHING_AROUND: Message = Message("app-nothing-around");
pub const NOTHING_NARRATED_AHEAD: Message = Message("app-nothing-narrated-ahead");
pub const NOTHING_NARRATED_BEFORE: Message = Message("app-nothing-narrated-before");
pub const ANSWER_FIRST: Message = Message("app-answer-first");
pub const NO_QUESTION: Message = Message("app-no-question");
pub const NOT_A_NUMBER: Message = Message("app-not-a-number");
pub const FIRST_RESULTS: Message = Message("app-first-results");
pub const RESULTS_TO_QUESTION: Message = Message("app-results-to-question");
pub const RESULTS: Message = Message("app-results");
pub const NOT_FOUND: Message = Message("app-not-found");
pub const FASTEST: Message = Message("app-fastest");
pub const SLOWEST: Message = Message("app-slowest");
pub const NO_LOOP: Message = Message("app-no-loop");
pub const NOTHING_UNDER_POINTER: Message = Message("app-nothing-under-pointer");
pub const NOTHING_DRAWN_THERE: Message = Message("app-nothing-drawn-there");
pub const OUTSIDE: Message = Message("app-outside");
pub const LARGEST: Message = Message("app-largest");
pub const SMALLEST: Message = Message("app-smallest");
pub const NO_SUCH_LESSON: Message = Message("app-no-such-lesson");
pub const STAYS: Message = Message("app-stays");
pub const STILL_MEASURING: Message = Message("app-still-measuring");
pub const NOTHING_IS_MEASURED: Message = Message("app-nothing-is-measured");
pub const NO_SUCH_STUDY: Message = Message("app-no-such-study");
pub const NO_SUCH_POINT: Message = Message("app-no-such-point");
pub const UNSAVED: Message = Message("app-unsaved");
pub const SAVE_AND_CLOSE: Message = Message("app-save-and-close");
pub const CLOSE_UNSAVED: Message = Message("app-close-unsaved");
pub const STAY: Message = Message("app-stay");
pub const CHANGED_BY_OTHERS: Message = Message("app-changed-by-others");
pub const SHARE_THE_FILES: Message = Message("app-share-the-files");
pub const SHARE_UNMOVED_ONLY: Message = Message("app-share-unmoved-only");
pub const SHARED_SCENE: Message = Message("app-shared-scene");
pub const NO_SUCH_CHANGE: Message = Message("app-no-such-change");
pub const SHARE_NO_STUDY: Message = Message("app-share-no-study");
pub const TOO_FAR: Message = Message("app-too-far");
pub const NO_VIEW: Message = Message("app-no-view");
pub const OUT_OF_RANGE: Message = Message("app-out-of-range");
pub const SHARE_UNCHANGED_ONLY: Message = Message("app-share-unchanged-only");
pub const SHARE_LESSON_ONLY: Message = Message("app-share-lesson-only");

/// What is said where the picture of a study's point is opened, by language.
pub fn said_of_a_point(point: &Point) -> [String; 2] {
    Language::ALL.map(|language| {
        let time = report::seconds(point.seconds.median, language);
        let setting = point.setting.text(language);
        let (setting, time) = (("setting", setting.as_str()), ("time", time.as_str()));
        match point
            .errors
            .map(|errors| language.significant(errors.rms, 2))
        {
            Some(error) => {
                Message("app-said-of-a-point").format(language, &[setting, ("error", &error), time])
            }
            None => Message("app-said-of-a-picture").format(language, &[setting, time]),
        }
    })
}
