"""The colors of the types of curves."""

COLORS = {
    "bspline": "#7f7f7f",
    "line": "#1f77b4",
    "circle": "#d62728",
    "arc": "#ff7f0e",
    "ellipse": "#9467bd",
    "elliptic_arc": "#e377c2",
}
