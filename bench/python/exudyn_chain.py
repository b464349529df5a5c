"""Exudyn: one `Mass1D` per winding, `CoordinateSpringDamper` between them and to the ground.

Coordinates are changes from the uniform chain at rest. u1 acts as a force 2Nk u1 on the first mass.
"""

import exudyn as exu
import exudyn.itemInterface as items

from measure import drive
from scipy_motion import start_line


def build(job):
    """The system, and its sensors at the first and last mass."""
    spring, n = job["spring"], job["spring"]["windings"]
    k = n * spring["stiffness"]
    places = start_line(job, job["start"]["position"]) - start_line(job, (0.0, job["mean_length"]))
    speeds = start_line(job, job["start"]["velocity"])
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    ground = mbs.AddNode(items.NodePointGround())
    wall = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))
    nodes, marks = [], []
    for place, speed in zip(places, speeds):
        start = {"initialCoordinates": [float(place)], "initialVelocities": [float(speed)]}
        nodes.append(mbs.AddNode(items.Node1D(referenceCoordinates=[0.0], **start)))
        mbs.AddObject(items.Mass1D(physicsMass=spring["mass"] / n, nodeNumber=nodes[-1]))
        marks.append(mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=nodes[-1], coordinate=0)))
    pairs = [(wall, marks[0], 2 * k), *((a, b, k) for a, b in zip(marks, marks[1:])), (marks[-1], wall, 2 * k)]
    for first, second, stiffness in pairs:
        mbs.AddObject(items.CoordinateSpringDamper(markerNumbers=[first, second], stiffness=stiffness, damping=0.0))
    if job["u1"]["kind"] != "held":
        u1 = drive(job)
        push = {"load": 1.0, "loadUserFunction": lambda mbs, t, load: 2 * k * float(u1(t))}
        mbs.AddLoad(items.LoadCoordinate(markerNumber=marks[0], **push))
    kind = exu.OutputVariableType.Coordinates
    sensors = [
        mbs.AddSensor(items.SensorNode(nodeNumber=node, storeInternal=True, outputVariableType=kind, writeToFile=False))
        for node in (nodes[0], nodes[-1])
    ]
    mbs.Assemble()
    return container, mbs, sensors


def settings_for(job, substeps):
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = float(job["times"][-1])
    settings.timeIntegration.numberOfSteps = (job["samples"] - 1) * substeps
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = 1 / job["rate"]
    settings.parallel.numberOfThreads = 1
    return settings


def simulation(job, method, substeps):
    """A function that simulates with `substeps` explicit steps of `method` per sample and returns the end forces."""
    spring, n, u1 = job["spring"], job["spring"]["windings"], drive(job)
    container, mbs, sensors = build(job)
    settings = settings_for(job, substeps)
    twice = 2 * n * spring["stiffness"]
    preload = spring["stiffness"] * (job["mean_length"] - spring["rest_length"])

    def solve():
        # Once more from the initial values: SolveDynamic starts from them, not from where it ended.
        mbs.SolveDynamic(settings, solverType=getattr(exu.DynamicSolverType, method))
        first, last = (mbs.GetSensorStoredData(sensor)[:, 1] for sensor in sensors)
        if len(first) != job["samples"]:
            raise RuntimeError(f"{len(first)} stored samples where {job['samples']} are due")
        return preload + twice * (first - u1(job["times"])), preload - twice * last

    solve.keep = container  # the system lives as long as its container
    return solve
