# Parameters of the cycles that measure angles, studs, rectangles, widths, coordinates, bolt-hole circles and planes.

# --- 422 ---
parameter-probing-centre-main__measure-stud =
    .help = Centre of the stud in the main axis of the working plane.
parameter-probing-centre-minor__measure-stud =
    .help = Centre of the stud in the secondary axis of the working plane.
parameter-probing-nominal-diameter__measure-stud =
    .help = Diameter of the stud.
parameter-number-of-touch-points__measure-stud =
    .help = Whether the stud is measured with four or three probings.
parameter-stud-greatest-diameter = Maximum limit of stud
    .label = MAXIMUM LIMIT
    .help = Greatest diameter permitted for the stud.
parameter-stud-least-diameter = Minimum limit of stud
    .label = MINIMUM LIMIT
    .help = Least diameter permitted for the stud.

# --- 423, 424 ---
parameter-probing-centre-main__measure-rectangular-pocket =
    .help = Centre of the pocket in the main axis of the working plane.
parameter-probing-centre-minor__measure-rectangular-pocket =
    .help = Centre of the pocket in the secondary axis of the working plane.
parameter-probing-centre-main__measure-rectangular-stud =
    .help = Centre of the stud in the main axis of the working plane.
parameter-probing-centre-minor__measure-rectangular-stud =
    .help = Centre of the stud in the secondary axis of the working plane.
parameter-probing-first-side-length = First side length
    .label = FIRST SIDE LENGTH
    .help = Length of the pocket, parallel to the main axis of the working plane.
parameter-probing-first-side-length__measure-rectangular-stud =
    .help = Length of the stud, parallel to the main axis of the working plane.
parameter-probing-second-side-length = Second side length
    .label = 2ND SIDE LENGTH
    .help = Length of the pocket, parallel to the secondary axis of the working plane.
parameter-probing-second-side-length__measure-rectangular-stud =
    .help = Length of the stud, parallel to the secondary axis of the working plane.
parameter-first-side-greatest-length = Maximum limit of first side length
    .label = MAX. LIMIT 1ST SIDE
    .help = Greatest length permitted for the pocket.
parameter-first-side-greatest-length__measure-rectangular-stud =
    .help = Greatest length permitted for the stud.
parameter-first-side-least-length = Minimum limit of first side length
    .label = MIN. LIMIT 1ST SIDE
    .help = Least length permitted for the pocket.
parameter-first-side-least-length__measure-rectangular-stud =
    .help = Least length permitted for the stud.
parameter-second-side-greatest-length = Maximum limit of second side length
    .label = MAX. LIMIT 2ND SIDE
    .help = Greatest width permitted for the pocket.
parameter-second-side-greatest-length__measure-rectangular-stud =
    .help = Greatest width permitted for the stud.
parameter-second-side-least-length = Minimum limit of second side length
    .label = MIN. LIMIT 2ND SIDE
    .help = Least width permitted for the pocket.
parameter-second-side-least-length__measure-rectangular-stud =
    .help = Least width permitted for the stud.
