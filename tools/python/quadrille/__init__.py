"""Quadrics in point clouds, and grasps on them.

    import numpy as np, quadrille
    found = quadrille.detect(points)                    # (N, 3) or (H, W, 3), metres
    plan = quadrille.plan(points, found, "franka")
    best = plan.grasps[0].X_CG                          # (4, 4)

The package also has the classes that lcm-gen makes of the LCM messages: quadrille.quadrics_t, …,
quadrille.drake.lcmt_point_cloud, quadrille.bot_core.pose_t, …. quadrille.lcm reads logs,
publishes and subscribes.

Lengths are in metres, angles in radians, times in milliseconds. Frame C is that of the points. A
pose X_AB takes points of frame B to frame A.
"""

import json as _json
import os as _os
from typing import Any as _Any
from typing import Dict as _Dict
from typing import List as _List
from typing import Mapping as _Mapping
from typing import Optional as _Optional
from typing import Tuple as _Tuple
from typing import Union as _Union

from numpy.typing import ArrayLike as _ArrayLike

from . import _core
from ._core import (Body, Box, Detection, FileError, Grasp, GraspQuery, Gripper, Plan, Remedy,
                    Result, TargetOutcome, __version__, conventions, grippers, read_cloud)
from ._lcmtypes import *

__all__ = ["Body", "Box", "Detection", "FileError", "Grasp", "GraspQuery", "GraspScene", "Gripper",
           "Plan", "Remedy", "Result", "TargetOutcome", "Tracker", "conventions", "detect", "grippers",
           "plan", "read_cloud"]

_Path = _Union[str, "_os.PathLike[str]"]
_Config = _Union[None, _Path, _Mapping[str, _Any]]

_ORIGIN = (0.0, 0.0, 0.0)


def _settings(config: _Config) -> _Tuple[str, str]:
    """Returns settings as TOML, and the name of their source in errors."""
    if config is None:
        return "", "config"
    if not isinstance(config, _Mapping):
        with open(config, encoding="utf-8") as file:
            return file.read(), _os.fspath(config)
    lines: _List[str] = []

    def add(table: _Mapping[str, _Any], prefix: str) -> None:
        for key, value in table.items():
            if isinstance(value, _Mapping):
                add(value, prefix + key + ".")
            else:
                lines.append(f"{prefix}{key} = {_json.dumps(value)}\n")

    add(config, "")
    return "".join(lines), "config"


def _gripper(gripper: _Union[_Path, Gripper]) -> Gripper:
    return gripper if isinstance(gripper, Gripper) else Gripper(_os.fspath(gripper))


def detect(points: _ArrayLike, *, viewpoint: _ArrayLike = _ORIGIN, config: _Config = None) -> Result:
    """Finds the quadrics of one cloud.

    points     array of shape (N, 3), or (H, W, 3) row by row of an organised cloud, in frame C [m];
               NaN where nothing was measured. float32 in C order is read in place, without a
               copy, so do not write to it meanwhile. Other types, such as float64, are converted.
    viewpoint  position of the sensor, in frame C [m]
    config     path of a TOML file, or a dict such as {"seed": 2, "only": ["sphere"],
               "planes.sigmas": 3.0}; `quadrille config` prints all settings

    Returns a Result, which is also a sequence of its Detections, best first. The same points and
    config give the same bits. Other Python threads can run meanwhile.
    Raises ValueError if points have another shape or a setting is wrong.
    """
    if isinstance(points, (str, _os.PathLike)):
        raise TypeError("detect() takes an array, not a path; read it: points, viewpoint = quadrille.read_cloud(path)")
    text, source = _settings(config)
    return _core.detect(points, viewpoint, text, source)


class GraspScene:
    """A cloud prepared for several queries for grasps.

    points, viewpoint, config  as for detect()
    result   what detect() found in these points
    gripper  name of a built-in gripper (see grippers()), path of a TOML file, or a Gripper
    """

    def __init__(self, points: _ArrayLike, result: Result, gripper: _Union[_Path, Gripper], *,
                 viewpoint: _ArrayLike = _ORIGIN, config: _Config = None) -> None:
        text, source = _settings(config)
        self._scene = _core.GraspScene(points, result, _gripper(gripper), viewpoint, text, source)

    @property
    def timings(self) -> _Dict[str, float]:
        """Time of each stage [ms]."""
        return self._scene.timings

    def plan(self, *, advise: bool = False, **query: _Any) -> Plan:
        """Returns the grasps that match a query, as a Plan, best first.

        targets        ids of detections and boxes
        tracks         tracks of detections
        types          types of the targets, such as ["cylinder"]
        near           only the target nearest to this point [m]
        roi            only targets whose centre lies between these two corners, least first [m]
        min_size, max_size          bounds on the longest side of a target [m]
        approach, approach_angle    direction of approach, and the largest angle to it [rad]
        reach          (base, least, greatest): the position of an arm's base, and bounds on the
                       distance of a grasp's origin from it, also before the approach [m]
        min_clearance  least distance of the hand from everything but its target [m]
        min_score      least probability of a grasp to succeed
        per_target     largest number of grasps of each target, unlike in place and direction; 0: a
                       dozen or so
        best           largest number of grasps
        deadline_ms    time after which the plan ends with the grasps found so far and a warning;
                       0: never
        accept         function that is called with each Grasp that has passed all other checks,
                       and returns whether it counts; its exceptions end the plan
        advise         also seeks what would give grasps to targets that have none, as
                       Plan.remedies; takes about as long as ten plans
        """
        return self._scene.plan(GraspQuery(**query), advise)


def plan(points: _ArrayLike, result: Result, gripper: _Union[_Path, Gripper], *,
         viewpoint: _ArrayLike = _ORIGIN, config: _Config = None, advise: bool = False,
         **query: _Any) -> Plan:
    """Plans grasps on what detect() found in these points: GraspScene(…).plan(advise=advise, **query)."""
    scene = GraspScene(points, result, gripper, viewpoint=viewpoint, config=config)
    return scene.plan(advise=advise, **query)


class Tracker:
    """Gives the detections of successive clouds lasting ids.

    config  as for detect(); only the table `track` is used
    """

    def __init__(self, config: _Config = None) -> None:
        self._tracker = _core.Tracker(*_settings(config))

    def update(self, result: Result, utime: int, X_WC: _Optional[_ArrayLike] = None) -> None:
        """Sets Detection.track of all detections of a Result.

        utime  time of the cloud [us]
        X_WC   pose of the cloud's frame in a fixed frame W, of shape (4, 4); by default, the
               camera is at rest
        """
        if X_WC is None:
            self._tracker.update(result, utime)
        else:
            self._tracker.update(result, utime, X_WC)
