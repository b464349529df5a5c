"""Where the compiled module finds how a result is laid out: data frames, plots, pages for notebooks."""

from coilsense._logs import (
    calibration_html,
    calibration_plot,
    identification_html,
    identification_plot,
    lines_frame,
    points_frame,
    recording_html,
)
from coilsense._studies import (
    experiment_html,
    experiment_plot,
    front_frame,
    indices_frame,
    limits_frame,
    mitigation_html,
    mitigation_plot,
    pareto_html,
    placement_html,
    ranking_frame,
    runs_frame,
    sensitivity_html,
)

__all__ = [
    "calibration_html",
    "calibration_plot",
    "identification_html",
    "identification_plot",
    "lines_frame",
    "points_frame",
    "recording_html",
    "experiment_html",
    "experiment_plot",
    "front_frame",
    "indices_frame",
    "limits_frame",
    "mitigation_html",
    "mitigation_plot",
    "pareto_html",
    "placement_html",
    "ranking_frame",
    "runs_frame",
    "sensitivity_html",
]
