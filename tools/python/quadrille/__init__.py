"""Quadrics in point clouds, and grasps on them.

    import numpy as np, quadrille
    found = quadrille.detect(points)                    # (N, 3) or (H, W, 3), metres
    plan = quadrille.plan(points, found, "franka")
    best = plan.grasps[0].X_CG                          # (4, 4)

The package also has the classes that lcm-gen makes of the LCM messages: quadrille.quadrics_t, …,
quadrille.drake.lcmt_point_cloud, quadrille.bot_core.pose_t, …. quadrille.lcm reads logs,
publishes and subscribes.

Lengths are in metres, angles in radians, times in milliseconds. Frame C is that of the points. A
pose X_AB takes points of frame B to frame A. Messages and JSON call X_CQ of a detection, X_CB of a
box or body and X_CK of a view `pose`; X_CG of a grasp is `pose` in messages, and X_CG in JSON.
"""

import json as _json
import os as _os
from typing import Any as _Any
from typing import Dict as _Dict
from typing import List as _List
from typing import Mapping as _Mapping
from typing import Optional as _Optional
from typing import Sequence as _Sequence
from typing import Tuple as _Tuple
from typing import Union as _Union

import numpy as _np
from numpy.typing import ArrayLike as _ArrayLike
from numpy.typing import NDArray as _NDArray

from . import _core
from ._arguments import answer_all as _answer_all
from ._arguments import answering as _answering
from ._arguments import answering_with as _answering_with

_answer_all(_core)  # before the names are imported below

from ._core import (Body, Box, CollisionShape, Detection, FileError, Grasp, GraspQuery, Gripper, Look, OctoMap,
                    Plan, Remedy, Result, Robot, Shape, Space, TargetOutcome, __version__, conventions,
                    grasp_of_hand, grippers, pose, quaternion, read_cloud)
from ._lcmtypes import *

__all__ = ["Body", "Box", "CollisionShape", "Detection", "FileError", "Grasp", "GraspQuery", "GraspScene",
           "Gripper", "LastingDetector", "Look", "OctoMap", "Plan", "Remedy", "Result", "Robot", "Shape", "Space",
           "TargetOutcome", "Tracker", "ViewMemory", "conventions", "detect", "grasp_of_hand", "grippers", "plan",
           "pose", "quaternion", "read_cloud", "read_octomap", "read_robot"]

_Path = _Union[str, "_os.PathLike[str]"]
_Config = _Union[None, _Path, _Mapping[str, _Any]]

# The points of each cloud, and its viewpoint or the pose of its camera.
_Views = _Sequence[_Tuple[_ArrayLike, _ArrayLike]]
_Shapes = _Union[_Path, _Sequence[Shape]]
_Robot = _Union[None, _Path, Robot, _Sequence[Shape]]
_OctoMap = _Union[None, _Path, bytes, OctoMap]

_ORIGIN = (0.0, 0.0, 0.0)


def _settings(config: _Config) -> _Tuple[str, str]:
    """Returns settings as TOML, and the name of their source in errors."""
    if config is None:
        return "", "config"
    if not isinstance(config, _Mapping):
        with open(_os.fspath(config), encoding="utf-8") as file:
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


@_answering
def read_robot(path: _Path) -> Robot:
    """Reads a file of the robot's own shapes, as for --robot: {"padding": …, "shapes": […]}.

    Raises FileError, a ValueError, in one line if it cannot be read.
    """
    return _core.read_robot(_os.fspath(path))


@_answering
def read_octomap(path: _Path) -> OctoMap:
    """Reads a map of the scene: a .bt file, or an .ot file with a tree of type OcTree.

    Raises FileError, a ValueError, in one line if it is no such map.
    """
    with open(_os.fspath(path), "rb") as file:
        return OctoMap(file.read(), _os.fspath(path))


def _robot(robot: _Robot) -> Robot:
    if robot is None:
        return Robot([])
    if isinstance(robot, (str, _os.PathLike)):
        return read_robot(robot)
    return robot if isinstance(robot, Robot) else Robot(robot)


def _shapes(shapes: _Shapes) -> _Sequence[Shape]:
    return read_robot(shapes).shapes if isinstance(shapes, (str, _os.PathLike)) else shapes


def _octomap(octomap: _OctoMap) -> _Optional[OctoMap]:
    if octomap is None or isinstance(octomap, OctoMap):
        return octomap
    if not isinstance(octomap, (str, bytes, _os.PathLike)):
        raise TypeError(f"incompatible octomap of type {type(octomap).__name__}; give an OctoMap, the path of its file, "
                        "or its bytes")
    return OctoMap(octomap, "octomap") if isinstance(octomap, bytes) else read_octomap(octomap)


def _viewpoint(viewpoint: _Optional[_ArrayLike], camera_pose: _Optional[_ArrayLike]) -> _ArrayLike:
    if viewpoint is not None and camera_pose is not None:
        raise ValueError("give either viewpoint or camera_pose; the place of the camera is the viewpoint")
    return _ORIGIN if viewpoint is None else viewpoint


@_answering
def detect(points: _ArrayLike, *, viewpoint: _Optional[_ArrayLike] = None, views: _Views = (), robot: _Robot = None,
           camera_pose: _Optional[_ArrayLike] = None, config: _Config = None) -> Result:
    """Finds the quadrics of one cloud, or of several views of one scene.

    points     array of shape (N, 3), or (H, W, 3) row by row of an organised cloud, in frame C [m];
               NaN where nothing was measured. float32 in C order is read in place, without a
               copy, so do not write to it meanwhile. Other types, such as float64, are converted.
    viewpoint  position of the sensor, in frame C [m]; by default the origin
    views      further clouds of the same scene at rest, each as (points, viewpoint), in frame C, or as
               (points, X_CV), in the frame V of its camera, whose pose is X_CV, (4, 4). They are
               first brought onto each other, within the errors that the settings `views` say their
               poses have; Result.corrections says how
    robot      the robot's own shapes in frame C, on which points are dropped: a Robot, a list of
               Shapes, or the path of a file (see read_robot())
    camera_pose  pose in C of the camera (z ahead, x along its rows), (4, 4), if C is another frame
               than the camera's. All work is then done in the camera's frame, where pixels lie in
               rows; results are in C all the same, and the viewpoint is the camera's place, so give no
               other
    config     path of a TOML file, or a dict such as {"seed": 2, "only": ["sphere"],
               "planes.sigmas": 3.0}; `quadrille config` prints all settings

    Returns a Result, which is also a sequence of its Detections, best first. The same points and
    config give the same bits. Other Python threads can run meanwhile.
    Raises ValueError if points have another shape or a setting is wrong.
    """
    if isinstance(points, (str, _os.PathLike)):
        raise TypeError("detect() takes an array, not a path; read it: points, viewpoint = quadrille.read_cloud(path)")
    text, source = _settings(config)
    return _core.detect(points, _viewpoint(viewpoint, camera_pose), views, _robot(robot), camera_pose, text, source)


class GraspScene:
    """A cloud prepared for several queries for grasps.

    points, viewpoint, views, robot, camera_pose, config  as for detect(). The robot's points are no
             obstacles either; they hide what is behind them, and the space of its shapes is free
    result   what detect() found in these points, or a Result of what you know: Result([Detection(…)])
    gripper  name of a built-in gripper (see grippers()), path of a TOML file, or a Gripper
    octomap  map of the scene: what it says is occupied is an obstacle, and what it says is free is
             free where no view tells. The path of a .bt or .ot file, its bytes, or an OctoMap (see
             OctoMap.from_voxels() for arrays)
    X_CM     pose of the map's frame in C, (4, 4); by default the map is in C
    support  (nx, ny, nz, d): the plane nx*x + ny*y + nz*z = d in frame C with its normal upwards, on
             which things stand; the hand stays above it when it takes them
    """

    @_answering
    def __init__(self, points: _ArrayLike, result: Result, gripper: _Union[_Path, Gripper], *,
                 viewpoint: _Optional[_ArrayLike] = None, views: _Views = (), robot: _Robot = None,
                 camera_pose: _Optional[_ArrayLike] = None, octomap: _OctoMap = None,
                 X_CM: _Optional[_ArrayLike] = None, support: _Optional[_ArrayLike] = None,
                 config: _Config = None) -> None:
        if X_CM is not None and octomap is None:
            raise ValueError("X_CM is the pose of a map, and no octomap is given")
        text, source = _settings(config)
        self._scene = _core.GraspScene(points, result, _gripper(gripper), _viewpoint(viewpoint, camera_pose), views,
                                       _robot(robot), camera_pose, _octomap(octomap), X_CM, support, text,
                                       source)

    @property
    def timings(self) -> _Dict[str, float]:
        """Time of each stage [ms]."""
        return self._scene.timings

    @_answering_with(GraspQuery)
    def plan(self, *, advise: bool = False, **query: _Any) -> Plan:
        """Returns the grasps that match a query, as a Plan, best first.

        targets        ids of detections, boxes and bodies
        tracks         tracks of detections, or of bodies for all that is part of them
        types          types of the targets, such as ["cylinder"]
        near           only the target nearest to this point [m]
        roi            only targets whose centre lies between these two corners, least first [m]
        region         the same with a box in any pose: its pose X_CR, (4, 4), and its sides, (3,) [m]
        min_size, max_size          bounds on the longest side of a target [m]
        approach, approach_angle    direction of approach, and the largest angle to it [rad]
        reach          (base, least, greatest): the position of an arm's base, and bounds on the
                       distance of a grasp's origin from it, also before the approach [m]
        obstacles      Shapes in frame C that the hand keeps off besides what the cloud shows; a list,
                       or the path of a file as for --obstacles
        attached       Shapes fixed to the hand, in its frame G, which must not touch anything either;
                       what counts is the box around each along the axes of G
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
                       Plan.remedies, and views that would help, as Plan.looks; takes about as
                       long as ten plans
        """
        return self._scene.plan(_query(query), advise, False)


def _query(query: _Dict[str, _Any]) -> GraspQuery:
    for name in ("obstacles", "attached"):
        if name in query:
            query[name] = _shapes(query[name])
    return GraspQuery(**query)


@_answering_with(GraspQuery)
def plan(points: _ArrayLike, result: Result, gripper: _Union[_Path, Gripper], *,
         viewpoint: _Optional[_ArrayLike] = None, views: _Views = (), robot: _Robot = None,
         camera_pose: _Optional[_ArrayLike] = None, octomap: _OctoMap = None,
         X_CM: _Optional[_ArrayLike] = None, support: _Optional[_ArrayLike] = None, config: _Config = None,
         advise: bool = False, **query: _Any) -> Plan:
    """Plans grasps on what detect() found in these points: GraspScene(…).plan(advise=advise, **query).

    Times and the deadline include the preparation of the scene.
    """
    asked = _query(query)
    scene = GraspScene(points, result, gripper, viewpoint=viewpoint, views=views, robot=robot,
                       camera_pose=camera_pose, octomap=octomap, X_CM=X_CM, support=support, config=config)
    return scene._scene.plan(asked, advise, True)


class Tracker:
    """Gives the surfaces and bodies of successive clouds lasting numbers. No surface and body share one.

    config  as for detect(); only the table `track` is used
    """

    @_answering
    def __init__(self, config: _Config = None) -> None:
        self._tracker = _core.Tracker(*_settings(config))

    @_answering
    def update(self, result: Result, utime: int, X_WC: _Optional[_ArrayLike] = None) -> None:
        """Sets Detection.track of all detections of a Result, and Body.track of its bodies.

        utime  time of the cloud [us]
        X_WC   pose of the cloud's frame in a fixed frame W, of shape (4, 4); by default, the
               camera is at rest
        """
        if X_WC is None:
            self._tracker.update(result, utime)
        else:
            self._tracker.update(result, utime, X_WC)


class _Memory:
    """What a ViewMemory and a LastingDetector have in common."""

    _memory: _Any

    @_answering
    def forget(self, X_WR: _Optional[_ArrayLike] = None, size: _Optional[_ArrayLike] = None) -> None:
        """Forgets all views, or the surfaces that they show in a box.

        X_WR  pose of the box's middle in W, (4, 4)
        size  sides of the box along the axes of that pose, (3,) [m]
        """
        if X_WR is None and size is None:
            self._memory.forget()
        elif X_WR is None or size is None:
            raise ValueError("a box needs both its pose X_WR and its size")
        else:
            self._memory.forget_box(X_WR, size)

    def __len__(self) -> int:
        """Returns the number of views that are kept."""
        return len(self._memory)


class ViewMemory(_Memory):
    """The views of a scene that moving cameras had, kept up to date.

    Of each camera there is one view for each direction of sight, and a newer one takes the place of an older one from
    there. What a new view contradicts is forgotten, and so is what is older than `views.remember`.

        memory.add(utime, points, X_WC)
        plan = quadrille.plan(points, found, "franka", views=memory.others(utime, X_WC))

    config  as for detect(); the tables `views` and `sampling` are used
    """

    @_answering
    def __init__(self, config: _Config = None) -> None:
        self._memory: _core.ViewMemory = _core.ViewMemory(*_settings(config))

    @_answering
    def add(self, utime: int, points: _ArrayLike, X_WC: _ArrayLike, *,
            viewpoint: _ArrayLike = _ORIGIN, camera: int = 0) -> _NDArray[_np.float64]:
        """Adds a view. If its time is before that of the camera's last one, later views are forgotten.

        utime      time of the cloud [us]
        points     as for detect(), without the robot: Robot.taken_from(points)
        X_WC       pose of the cloud's frame in a fixed frame W, as far as it is known, (4, 4)
        viewpoint  as for detect()
        camera     number of the camera; all cameras have one clock

        Returns the motion within W that corrects the pose, (4, 4).
        """
        return self._memory.add(utime, points, viewpoint, X_WC, camera)

    @_answering
    def others(self, utime: int, X_WC: _ArrayLike, *,
               camera: int = 0) -> _List[_Tuple[_NDArray[_np.float32], _NDArray[_np.float64]]]:
        """Returns the views but the one that this camera had at this time, the newest first, as
        (points, viewpoint).

        X_WC  pose in W of the frame C in which they are wanted; that of the camera's last view is
              corrected as this one was
        """
        return self._memory.others(utime, X_WC, camera)


class LastingDetector(_Memory):
    """Detects the quadrics of a scene that lasts while cameras move about it.

    It keeps what the views of each cloud showed, as ViewMemory keeps the clouds, and fits each surface to
    all that the views show of it. If a cloud shows nothing, the result is what the other views showed, and
    a warning says so. A view that stands alone gives the bits of detect(). Other Python threads wait while
    it detects.

        found = detector.detect(utime, points, X_WC)

    config  as for detect()
    """

    @_answering
    def __init__(self, config: _Config = None) -> None:
        self._memory: _core.LastingDetector = _core.LastingDetector(*_settings(config))

    @_answering
    def detect(self, utime: int, points: _ArrayLike, X_WC: _ArrayLike, *, viewpoint: _ArrayLike = _ORIGIN,
               robot: _Robot = None, camera: int = 0) -> Result:
        """Detects what a cloud and the views before it show, in the cloud's frame C, and keeps the view.

        utime, points, X_WC, viewpoint, camera  as for ViewMemory.add(); the robot's points may be
               among the points if its shapes are given
        robot  the robot's own shapes in frame C, as for detect()
        """
        return self._memory.detect(utime, points, viewpoint, X_WC, _robot(robot), camera)
