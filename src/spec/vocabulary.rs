//! The fixed words of the files: keywords, groups, kinds, verbs.
//!
//! Invariant: words of the form, not of any language that a person reads.
use super::decode::words;

words! {
    /// How the cycle is written in a program.
    pub enum Keyword {
        /// Machining cycles, transforms, special cycles.
        CyclDef = "CYCL DEF",
        /// Touch-probe cycles.
        TchProbe = "TCH PROBE",
    }
}

words! {
    /// When a cycle acts.
    pub enum TakesEffect {
        /// When it is called.
        OnCall = "on-call",
        /// As soon as it is defined.
        OnDefinition = "on-definition",
    }
}

words! {
    /// The groups of the overview, in its order.
    pub enum Group {
        /// Drilling.
        Drilling = "drilling",
        /// Threads.
        Threads = "threads",
        /// Pockets, studs and slots.
        Pockets = "pockets",
        /// Patterns.
        Patterns = "patterns",
        /// Contours.
        Contours = "contours",
        /// Surfaces.
        Surfaces = "surfaces",
        /// Coordinate transforms.
        Transforms = "transforms",
        /// Special cycles.
        Special = "special",
        /// Turning.
        Turning = "turning",
        /// Workpiece misalignment.
        Rotation = "rotation",
        /// Datum setting.
        Datum = "datum",
        /// Workpiece measurement.
        Measuring = "measuring",
        /// Probe calibration.
        Calibration = "calibration",
        /// Machine kinematics.
        Kinematics = "kinematics",
        /// Tool measurement.
        ToolMeasurement = "tool-measurement",
        /// Digitizing.
        Digitizing = "digitizing",
    }
}

words! {
    /// What kind of entry a parameter takes.
    pub enum ParameterKind {
        /// A number.
        Number = "number",
        /// A whole number.
        Integer = "integer",
        /// A number or a name in quotation marks.
        NumberOrName = "number-or-name",
        /// A text.
        Text = "text",
        /// The number of a Q parameter.
        QNumber = "q-number",
        /// An axis with the direction of a movement.
        AxisDirection = "axis-direction",
        /// Coordinates by axis.
        Position = "position",
        /// A row of a table.
        Row = "row",
        /// An axis.
        Axis = "axis",
        /// Numbers of labels with bars between them: `1/2/3`.
        LabelList = "label-list",
    }
}

words! {
    /// What a value measures.
    pub enum Quantity {
        /// mm.
        Length = "length",
        /// Degrees.
        Angle = "angle",
        /// mm/min.
        Feed = "feed",
        /// Seconds.
        Time = "time",
        /// Revolutions per minute.
        Speed = "speed",
        /// A number of things.
        Count = "count",
        /// A factor.
        Factor = "factor",
        /// A number that stands for something: a choice, a row, a mode.
        Number = "number",
        /// A text.
        Text = "text",
        /// Nothing measurable.
        None = "none",
    }
}

impl Quantity {
    /// The unit in which values are given, if it has one.
    pub const fn unit(self) -> Option<&'static str> {
        match self {
            Self::Length => Some("mm"),
            Self::Angle => Some("°"),
            Self::Feed => Some("mm/min"),
            Self::Time => Some("s"),
            Self::Speed => Some("rpm"),
            _ => None,
        }
    }
}

words! {
    /// What a coordinate counts from.
    pub enum Reference {
        /// From a position or surface.
        Incremental = "incremental",
        /// From the active datum.
        Absolute = "absolute",
    }
}

words! {
    /// How serious a note is.
    pub enum NoteKind {
        /// People can be hurt or the machine destroyed.
        Danger = "danger",
        /// Workpiece, tool or probe can be damaged.
        Caution = "caution",
        /// Worth knowing.
        Note = "note",
        /// The machine builder decides or must prepare it.
        MachineBuilder = "machine-builder",
    }
}

words! {
    /// Values of a parameter that no control refuses and hardly anybody means.
    pub enum Doubtful {
        /// 0.
        Zero = "zero",
        /// Below 0.
        Negative = "negative",
        /// Above 0.
        Positive = "positive",
    }
}

words! {
    /// What a guard does when it applies.
    pub enum Outcome {
        /// An error: the program stops.
        Error = "error",
        /// The cycle is not executed.
        Skip = "skip",
        /// A warning.
        Warn = "warn",
        /// The operator must agree.
        Confirm = "confirm",
    }
}

words! {
    /// When a guard is evaluated.
    pub enum Moment {
        /// When the cycle is defined.
        Definition = "definition",
        /// When it is executed.
        Call = "call",
    }
}

words! {
    /// How an old-style field is written.
    pub enum Shape {
        /// A printed word, then the value: `ALT.: +120`.
        Labelled = "labelled",
        /// A fixed word with the value: `ROT+35`.
        Word = "word",
        /// A Q parameter: `Q5`.
        Q = "q",
        /// An axis with a sign: `X-`.
        AxisDirection = "axis-direction",
        /// Coordinates: `X+5 Y+0 Z-5`.
        Position = "position",
        /// One coordinate: `X+60` or `IX+5`.
        AxisCoordinate = "axis-coordinate",
        /// A row: `#5`.
        Row = "row",
        /// Axes by their letters: `X Y`.
        Axes = "axes",
        /// Coordinates of a centre: `CCX+15 CCY+20`.
        Centre = "centre",
    }
}

words! {
    /// Whether a table is read or written.
    pub enum Access {
        /// Read.
        Reads = "reads",
        /// Written.
        Writes = "writes",
    }
}

words! {
    /// Who does a step.
    pub enum Actor {
        /// The control.
        Control = "control",
        /// The operator.
        Operator = "operator",
    }
}

words! {
    /// The verbs of actions.
    pub enum Verb {
        /// Move at rapid traverse.
        Rapid = "rapid",
        /// Move at a feed.
        Feed = "feed",
        /// Move on an arc.
        Arc = "arc",
        /// Wait.
        Dwell = "dwell",
        /// Turn the spindle on or off.
        Spindle = "spindle",
        /// Orient the spindle.
        Orient = "orient",
        /// Switch the coolant.
        Coolant = "coolant",
        /// Move with the spindle synchronized.
        Synchronized = "synchronized",
        /// Probe towards a point.
        Probe = "probe",
        /// Change the coordinate system.
        Transform = "transform",
        /// Keep modal data for later cycles.
        Remember = "remember",
        /// Call the last cycle defined.
        Call = "call",
        /// Set Q parameters.
        Set = "set",
        /// Set the Q parameter that a field names.
        Store = "store",
        /// Bind names.
        Let = "let",
        /// Write a table.
        Table = "table",
        /// Write a log.
        Log = "log",
        /// Fit an ideal shape to collected points.
        Fit = "fit",
        /// Lock a tool.
        Lock = "lock",
        /// Stop with an error.
        Fail = "fail",
        /// Show a message.
        Message = "message",
        /// Ask the operator and wait.
        Ask = "ask",
        /// Do what a fragment says.
        Use = "use",
        /// A named strategy of the engine.
        Strategy = "strategy",
    }
}
