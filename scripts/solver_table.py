#!/usr/bin/env python3
"""Writes docs/theory/solver-table.md: each element, material, condition and contact with its test and its error.

    scripts/solver_table.py BUILD/tests/solver/gapcheck_test_solver

Runs the tests. The error is what a test records as a property; of a test that records nothing, the loosest tolerance that
it asserts, which is read from its source.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE, TESTS = ROOT / "docs" / "theory" / "solver-table.md", ROOT / "tests" / "solver"

# Section, or (what, reference, test, property or None, what the property would be without error).
ROWS = [
    "Elements",
    ("shell 2, quads: deflection of a cantilever", "1 − 1/(4 n²) of the beam's", "ShellCantilever.DeflectionConvergesWithSecondOrder", None, 0),
    ("shell 2, quads: first frequency of a plate, 24 x 24", "Mindlin", "Vibration.SimplySupportedPlateOfQuads", "plate_of_quads_6_12_24_error_3", 0),
    ("shell 2, triangles: the same", "Mindlin", "Vibration.SimplySupportedPlateOfTriangles", "plate_of_triangles_6_12_24_error_3", 0),
    ("shell 17: first frequency of a plate, 24 x 24", "Kirchhoff", "Vibration.SimplySupportedPlateOfKirchhoffTriangles", "plate_of_kirchhoff_triangles_6_12_24_error_3", 0),
    ("shell 17: stiffness", "Hx and Hy of Batoz, Bathe and Ho (1980)", "KirchhoffTriangle.BendsAsPublished", None, 0),
    ("shell 17: clamped circular plate under pressure, 8 rings", "p R⁴ / 64 D", "KirchhoffTriangle.ClampedCircularPlateConverges", "pressure_error", 0),
    ("shell 2: membrane and bending patch", "even stress", "ShellPatch.*", None, 0),
    ("shell 2: fully plastic moment", "σ t²/4", "Shell.PlasticMoment", None, 0),
    ("shell 16: first frequency of a plate, 24 x 24", "Mindlin", "Vibration.SimplySupportedPlateOfFullQuads", "plate_of_full_quads_6_12_24_error_3", 0),
    ("shell 16: twisted beam, thick, load in its plane", "MacNeal and Harder (1985)", "FullShellCantilever.TwistedBeam", "thick_in_plane", 1),
    ("shell 16: twisted beam, thin, load out of its plane", "MacNeal and Harder (1985)", "FullShellCantilever.TwistedBeam", "thin_out_of_plane", 1),
    ("shell 16: stiffness", "slow twin in Cartesian strains", "FullShell.StiffnessOfItsTwin", None, 0),
    ("shell 16: step of warped quads, the least of 800 random ones", "2/ω of all eigenvalues", "WarpedFrequency.NeverAboveTheExactStepAndCloseToIt", "least_share_of_the_exact_step", 1),
    ("shell 16: full turn of a warped, stressed element", "no strain", "FullShell.RigidRotationIsFree", None, 0),
    ("shells 2, 10, 16 with INN: other first node, far beyond yield", "the same forces", "ShellAxes.AllOrdersOfTheCornersGiveTheSameForces", None, 0),
    ("shell 2 with BWC, PROJ = 0: twisted beam, load in its plane", "MacNeal and Harder (1985)", "ShellWarping.TwistedBeam", "drill_in_plane", 1),
    ("shell 2 with BWC, PROJ = 1: the same, load out of its plane", "MacNeal and Harder (1985)", "ShellWarping.TwistedBeam", "full_out_of_plane", 1),
    ("shell 10: bending patch of irregular quads", "no shear", "ShellWarping.SidesShearPassesTheBendingPatch", None, 0),
    ("shells of plies: stiffness", "laminate theory", "ShellLayers.LaminateTheory", None, 0),
    ("shells of plies of their own", "laminate theory", "BuildShellLayers.PliesOfOneElement", None, 0),
    ("shells with listed points", "Σ E WF t (S t/2)²", "BuildShellLayers.ListedPoints", None, 0),
    ("shells with nodes on a surface: cantilever", "nodes in the middle", "ShellLayers.CantileverWithNodesOnASurface", "offset_one_point", 1),
    ("shells: bulk viscosity", "closed form", "ShellLayers.BulkViscosity", None, 0),
    ("solid 1 with IHQ 6, QM = 1: cantilever of one layer", "P l³/3EI + P l/GA", "AssumedStrain.OneLayerBends", "cantilever_0.3", 1),
    ("solid 1: patch with viscous and stiff control", "even stress", "SolidPatch.LinearField", None, 0),
    ("solid 1: first frequency of a bar, 20 bricks", "c / 2 l", "Vibration.RodOfBricks", "rod_of_bricks_5_10_20_error_3", 0),
    ("solid 1: first frequency of a beam, 8 layers", "Timoshenko", "Vibration.BeamOfBricks", "beam_of_bricks_2_4_8_layers_error_3", 0),
    ("solid 2: stiffness", "slow twin with Hughes' matrices", "SolidEight.StiffnessIsThatOfTheSlowTwin", None, 0),
    ("solid 2: tip of a cantilever, four layers", "Timoshenko", "SolidEightCantilever.TipsConverge", "tip_errors_1", 0),
    ("solid −1: the same", "Timoshenko", "SolidEightCantilever.TipsConverge", "tip_errors_2", 0),
    ("solid −2: the same", "Timoshenko", "SolidEightCantilever.TipsConverge", "tip_errors_3", 0),
    ("solid 15: the same", "Timoshenko", "SolidEightCantilever.TipsConverge", "tip_errors_4", 0),
    ("solid 13: mean stress", "slow twin with averages at the nodes", "SolidNodalPressure.MeanStressIsTheMeanOfTheNodesOfThePart", None, 0),
    ("solid 13: thick tube under pressure, ν = 0.4999, four layers", "Lamé", "SolidNodalPressure.NoLockingInANearlyIncompressibleTube", "fine", 1),
    ("solid 13: full turn of stressed tetrahedra", "no strain", "SolidNodalPressure.AFullTurnKeepsTheStress", None, 0),
    ("solid 13: length of Taylor's bar", "Bonet and Burton (1998)", "SolidNodalPressure.TaylorBar", "length", 21.5),
    ("thick shell 1: deflection of a thin cantilever, 16 shells", "beam with shear", "ThickShell.CantileverConvergesWithSecondOrder", "thin", 0),
    ("thick shell 1: patch of four", "even stress", "ThickShell.PatchOfFour", None, 0),
    ("thick shell 1: first frequency of a cantilever", "Euler and Bernoulli", "BuildThickShells.FirstFrequencyOfACantilever", "frequency", 1),
    ("beam 6: mass on a spring of material 066", "v sin ωt / ω", "BuildDiscreteBeams.AMassOnASpringVibrates", "free", 0),
    ("beam 6: full turn of a stressed beam", "no strain", "DiscreteBeam.AFullTurnTurnsTheForces", None, 0),
    ("beam 6: yield and reversed yield of material 068", "the card's curve", "DiscreteBeam.PlasticForcesHardenUnloadAndBalance", None, 0),
    ("beam 6: pendulum on a cable (071)", "3 m g", "BuildDiscreteBeams.PendulumOnACable", "pendulum", 0),
    ("shell 5 and 9: strip thrown across", "does not bend", "Membrane.DoesNotBend", None, 0),
    ("beam 2: cantilever", "P l³/3EI + P l/GA", "Beam.Cantilever", None, 0),
    ("beam 2: full turn of a stressed beam", "no strain", "Beam.RigidRotation", None, 0),
    ("beam 2: load beside a hinge", "6 E I w / L³", "BeamHinge.LoadBetweenTwoCantilevers", "hinged", 1),
    ("beam 2 off its nodes: eccentric tension", "P L/EA + P e² L/EI", "BeamOffset.EccentricTension", "resultant", 1),
    ("beam 1 with NSLOC: the same", "P L/EA + P e² L/EI", "BeamOffset.EccentricTension", "nsloc", 1),
    ("beam off its nodes: full turn when stressed", "the same forces turned", "BeamOffset.FullTurnKeepsTheForces", None, 0),
    ("beam 1 and 9: constants of the section", "closed form", "IntegratedBeam.ConstantsOfTheSection", None, 0),
    ("beam 1 and 9: fully plastic moment and torque", "sum over the points", "IntegratedBeam.PlasticMomentAndTorque", None, 0),
    ("truss 3: yield and reversed yield", "bilinear law", "Truss.YieldsAndHardens", None, 0),
    ("spring and damper: period, decay", "discrete closed form", "Springs.PeriodOfAMassOnTheGround", None, 0),
    ("spring S03: mass stopped by plastic work", "FY²/2K + FY u_p = m v²/2", "Springs.PlasticSpringStopsAMass", None, 0),
    ("spring S03: reversed yield", "bilinear law, isotropic hardening", "SpringLaw.ElastoplasticPath", None, 0),
    ("damper S05: decay in either sense", "discrete closed form", "Springs.NonlinearDamper", None, 0),
    ("spring S07: even rate, relaxation", "closed form", "SpringLaw.MaxwellAtAnEvenRateAndAtRest", None, 0),
    ("spring S08: rebound of two masses", "√(k / KU)", "Springs.InelasticSpringGivesBackALittle", None, 0),
    "Materials",
    ("001: stresses of unit strains", "Hooke", "Material.ElasticClosedForms", None, 0),
    ("003: bar of bricks pulled by 15 %", "the card's curve", "All/PulledBar.FollowsTheCurve/bricks_003", "pulled_bar_bricks_003_largest_error", 0),
    ("024: bar of bricks pulled by 15 %", "the card's curve", "All/PulledBar.FollowsTheCurve/bricks_024", "pulled_bar_bricks_024_largest_error", 0),
    ("024: bar of shells pulled by 15 %", "the card's curve", "All/PulledBar.FollowsTheCurve/shells_024", "pulled_bar_shells_024_largest_error", 0),
    ("003 and 024 with VP = 1: relaxation", "implicit steps in closed form", "Viscoplastic.RelaxesTowardsTheStaticStress", None, 0),
    ("027: stress", "slope of the energy", "Rubber.StressIsTheSlopeOfTheEnergy", None, 0),
    ("027: fit to a test", "constants that made the curve", "MooneyRivlinFit.GivesTheConstantsOfItsTestBack", None, 0),
    ("002, 034: pull at 45 degrees", "turned compliance", "Orthotropic.TurnedAxes", None, 0),
    ("034 with CSE", "tension alone", "Orthotropic.OnlyTension", None, 0),
    ("006: relaxation", "closed form", "Viscoelastic.Relaxation", None, 0),
    ("007: shear and dilatation", "closed form", "PrincipalLaw.BlatzKo", None, 0),
    ("007, 057, 077, 181: stress", "slope of the energy", "PrincipalLaw.StressIsTheSlopeOfTheEnergy", None, 0),
    ("018: yield stress", "K (ε₀ + ε̄)^N", "PowerLaw.YieldStress", None, 0),
    ("057: brick pressed and pulled", "the card's curve", "LowDensityFoam.BrickFollowsTheCurve", None, 0),
    ("057, 181: loop of hysteresis", "W_max (1 − HU) SHAPE/(SHAPE + 1)", "FiniteLaw.Hysteresis", None, 0),
    ("063: loading, unloading, cutoff", "the card's curve", "CrushableFoam.UniaxialPath", None, 0),
    ("081: damaged stress", "(1 − ω) times that of 024", "PlasticityWithDamage.FollowsTheUndamagedStress", None, 0),
    ("123: EPSTHIN, EPSMAJ", "strains of constant volume", "ModifiedPlasticity.FailsByItsStrains", None, 0),
    ("181: uniaxial load, foam and rubber", "the card's curve", "PrincipalLaw.TabulatedLawGivesItsCurveBack", None, 0),
    ("181 with a table: constant rates", "curve between the table's", "RateLaws.ConstantRate", None, 0),
    ("037: yield and thinning under tension", "R / (1 + R)", "Anisotropic.UniaxialYieldAndThinning", None, 0),
    ("100: failure by each resultant", "the card's value", "SpotWeld.FailsAtItsResultants", None, 0),
    ("100 in bricks: resultants of 200 warped bricks", "sums at both faces", "WeldBrick.ResultantsOfWarpedBricks", None, 0),
    ("015: adiabatic shear", "exponential softening", "JohnsonCook.AdiabaticShear", None, 0),
    ("015: strain at failure", "Johnson and Cook (1985)", "JohnsonCook.StrainAtFailure", None, 0),
    ("009 with EOS 004: Hugoniot", "ρ₀ C² η / (1 − S₁ η)²", "EquationOfState.GruneisenMeetsItsHugoniot", None, 0),
    ("009 with EOS 001: gas pressed to half its volume", "p₀ V^−1.4", "EquationOfState.AdiabatOfAnIdealGas", None, 0),
    ("010: uniaxial strain", "slow twin with fine steps", "Hydro.UniaxialStrainAgainstASlowTwin", None, 0),
    ("`*MAT_ADD_EROSION`: impulse", "closed form", "Erosion.Impulse", None, 0),
    "Conditions",
    ("prescribed displacement", "met at each step", "PrescribedMotion.DisplacementIsMetAtTheSteps", None, 0),
    ("prescribed turn of a rigid body", "closed form", "PrescribedMotion.TurnOfARigidBody", None, 0),
    ("initial velocity by a turn", "ω × r", "InitialVelocity.GenerationTurnsAPart", None, 0),
    ("gravity", "g t²/2", "Loads.FallingBodies", None, 0),
    ("pressure in a closed box", "no resultant", "Loads.PressureInAClosedBox", None, 0),
    ("global damping", "discrete closed form", "Loads.GlobalDamping", None, 0),
    ("preload of a beam", "two masses and a spring", "BeamPreload.FollowsTheCurveAndLetsGo", None, 0),
    ("start stress: bar between supports", "σ A", "InitialStress.UniformIsInEquilibrium", None, 0),
    ("start stress: brick let go", "σ L / E (1 − cos ω t)", "InitialStress.LetsGo", None, 0),
    ("relaxation: bar under its load", "ln(l/L) = F/EA", "RelaxationRun.BarUnderItsLoadComesToRest", "error", 0),
    ("relaxation: bolt of bricks in the run", "σ A", "RelaxationRun.PreloadOfASectionStays", "error", 0),
    ("preload of a section: load on a tightened bolt", "two springs", "SectionPreload.LoadedBoltIsTwoSprings", None, 0),
    ("rigid wall: impulse and energy of a stop", "m v, m v²/2", "RigidWalls.PlasticStop", None, 0),
    ("rigid wall: rod", "ρ c v A", "RigidWalls.RodAgainstTheWall", None, 0),
    ("rigid wall with a mass against a rod", "V₀ exp(−ρ c A t/M)", "WallImpulse.WallWithAMassAgainstARod", "moving_wall_velocity_error", 0),
    ("rigid wall by a curve", "the node is on it", "WallImpulse.WallThatFollowsACurve", None, 0),
    ("rigid wall: rigid cube on springs (RWPNAL)", "v √(4 k m)", "WallPenalty.RigidCubeBounces", "wall_penalty_force_ratio", 1),
    ("joints: quarter period of a pendulum", "√(I / m g d) K(sin 45°)", "RigidJoints.Pendulum", "pendulum_REVOLUTE", 1),
    ("joints: slider and crank", "r cos ωt + √(l² − r² sin² ωt)", "RigidJoints.SliderCrank", "slider_crank_error", 0),
    ("joints: universal joint", "tan φ₂ = tan φ₁ cos β", "RigidJoints.UniversalJoint", "universal_joint_error", 0),
    ("nodes that follow others: accelerations", "all equations of motion at once", "FollowerForces.AgreesWithAllEquationsAtOnce", None, 0),
    ("nodes that follow others: two turns of nine degrees per step", "circle", "FollowerForces.FiniteRotationsPassExactly", None, 0),
    ("DT2MS: truss pressed to half its length", "m (L₀/L)²", "MassScaling.GrowsDuringTheRun", None, 0),
    ("frame that turns", "r cosh(n α)", "Loads.TurningFrame", None, 0),
    ("linear constraints: periodic pairs", "all equations of motion at once", "LinearConstraints.GroupsAreSolvedAtOnce", None, 0),
    ("nodes that share a direction", "F / Σ m", "LinearConstraints.JoinedNodesShareTheirMomentum", None, 0),
    ("airbag: volume and forces of a box", "closed form", "ControlVolume.Box", None, 0),
    ("airbag: warped boxes, near and far from the origin", "both cuts of each quad into triangles, differences", "ControlVolume.WarpedBoxes", None, 0),
    ("airbag: compression without flow", "p V^k", "AirbagGas.CompressionWithoutFlow", None, 0),
    ("airbag: flow through the exit", "speed and density in the exit", "AirbagGas.ExitRate", None, 0),
    ("airbag: blowdown into vacuum", "closed form of choked flow", "AirbagGas.BlowdownIntoVacuum", None, 0),
    ("damping relative to a rigid body", "−D m (v − V − ω × r)", "Loads.RelativeDampingIsThatOfTheRelativeVelocity", None, 0),
    ("damping of a part", "(1 − D dt)ⁿ", "Loads.DampingOfParts", None, 0),
    ("rigid body: steady spin", "discrete closed form", "RigidBody.SteadySpin", None, 0),
    ("secforc: force behind a section while a wave passes", "rate of momentum", "Sections.ForceIsTheRateOfMomentum", None, 0),
    ("secforc: bar and strip of shells", "stress times area, ∫ σ z dA", "Sections.*", None, 0),
    ("spcforc: bar between support and load", "rate of momentum", "Supports.BalanceLoadsAndInertia", None, 0),
    ("bndout: works of loads and motions", "kinetic energy", "BoundaryWork.BodiesAndPressures", None, 0),
    ("rwforc: rod", "momentum lost", "Walls.StopARod", None, 0),
    ("swforc: links and brick", "m a, σ A", "Welds.*", None, 0),
    ("spotweld constraint: failure by tension", "SN", "Welds.NormalFailure", None, 0),
    "Contacts",
    ("types 3, a3, 5, a5, 10, a10, 13, a13, 26: two plates thrown at each other", "momentum and energy come back", "All/ContactTypes.*", None, 0),
    ("penalty: deepest point over SFS", "exponent −1/2", "Penalty.DepthAndTimeFallWithTheRootOfTheScale", "penetration_over_SFS_exponent", -0.5),
    ("*PART_CONTACT: SSF, OPTT, SFT", "K A / diagonal, thickness", "Penalty.PartsScaleTheirStiffnessAndThickness", None, 0),
    ("*PART_CONTACT: friction, FS = -1", "FD + (FS - FD) exp(-DC v), VC", "Penalty.PartsHaveTheirFriction", None, 0),
    ("two rods: stress", "ρ c v / 2", "Impact.EqualRodsExchangeTheirVelocities", "rods_stress_error_80", 0),
    ("two rods: time of contact", "2 l / c", "Impact.EqualRodsExchangeTheirVelocities", "rods_contact_time_error_80", 0),
    ("ball on a plate", "Hertz: force over 4/3 E* √R δ^1.5", "Hertz.BallOnARigidPlate", "hertz_constant_ratio", 1),
    ("ball on a plate, mortar", "Hertz", "Hertz.BallOnARigidPlateByMortar", "hertz_mortar_constant_ratio", 1),
    ("friction: way of a block to rest", "v²/2 μ g", "ContactForces.BlockSlidesToRest", None, 0),
    ("SOFT = 2: fine on coarse mesh", "even pressure", "SegmentRule.FineOnCoarseIsUniform", None, 0),
    ("edges: two crossing beams", "elastic impact", "EdgePass.CrossingBeamsExchangeTheirVelocities", None, 0),
    ("mortar: even pressure through 4 x 4 on 6 x 6 bricks", "even stress", "All/MortarPatch.EvenPressureOnOtherMeshes/parts", "misfit_4_6_0_false", 0),
    ("mortar: block slides to rest", "v²/2 μ g", "MortarFriction.SlidesToRest", "way_ratio", 1),
    ("INTERFERENCE: press fit of rings", "Lamé", "Interference.PressFitOfRings", "pressure_ratio", 1),
    ("tie 7: two halves of a plate of shells", "one piece", "Cantilever/TiedShells.BendsLikeOnePiece/type_7", "deflection", 1),
    ("tie 2: two halves of a beam of bricks", "one piece", "Cantilever/TiedBricks.BendsLikeOnePiece/type_2", "deflection", 1),
    ("tie b6 with SFS = SFM = 1", "one piece", "Cantilever/TiedBricks.BendsLikeOnePiece/type_b6_by_default", "deflection", 1),
    ("ties by springs: force", "dense matrices", "Ties/DenseTwin.SameForces/*", None, 0),
    ("welds between two sheets: force and moment at both ends", "balance of a sheet", "Welds/WeldJoint.CarriesTheLoadAndItsMoments/*", None, 0),
    ("tiebreak, bilinear laws, power and B-K: mixed mode", "criterion of the energies", "CohesiveLaw.MixedModesFailByTheirCriterion", None, 0),
    ("tiebreak 7, 9, 10, 11: modes I and II", "ERATEN, ERATES", "Tiebreak.CohesiveLawsTakeTheirEnergies", None, 0),
    ("tiebreak 5: plastic with a curve", "area below the law", "Tiebreak.PlasticLawSoftens", None, 0),
    ("TIED_SURFACE_TO_SURFACE_FAILURE: stress at failure", "FS, FD", "TiedWithFailure.FailsByItsStresses", None, 0),
    ("rigid bodies by a force curve: rebound", "energy of the curve", "CurveContact.ReboundGivesBackWhatTheCurveStores", None, 0),
    ("tiebreak, linear damage", "fracture energy", "Tiebreak.LinearDamageTakesTheFractureEnergy", None, 0),
    ("tiebreak, OPTION 1: nodes that stick when they touch", "lone masses on springs", "TieStick.AgreesWithLoneMasses", None, 0),
    ("tiebreak, OPTION 1: amplitude after the touch", "v / ω", "TieStick.TouchedNodesStayAndSwingInAllDirections", None, 0),
]

HEAD = """# Elements, materials, conditions and contacts: test, reference, error

`scripts/solver_table.py` runs `gapcheck_test_solver` and writes this page. The error is relative, as the test measured it;
"at most" gives the loosest tolerance that a test asserts, where it records no number. The pages of the parts tell how each
test works, [accuracy](solver-accuracy.md) gives the orders of convergence, [benchmarks](solver-benchmarks.md) whole problems.
"""


def results(program, names):
    """By full name: passed, and the recorded properties."""
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / "tests.json"
        subprocess.run([program, f"--gtest_filter={':'.join(names)}", f"--gtest_output=json:{output}", "--gtest_brief=1"],
            check=True)
        suites = json.loads(output.read_text())["testsuites"]
    return {f"{suite['name']}.{test['name']}": test for suite in suites for test in suite["testsuite"]}


def source_of(test):
    """The name and the text of the test's function."""
    suite, name = test.split("/", 1)[-1].split(".", 1) if "/" in test.split(".")[0] else test.split(".", 1)
    name = name.split("/")[0]
    pattern = rf"^TEST(?:_P|_F)?\({suite}, {'[A-Za-z0-9]+' if name == '*' else name}\) \{{\n.*?^\}}"
    for path in sorted(TESTS.rglob("*_test.cpp")):
        bodies = re.findall(pattern, path.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
        if bodies:
            return path.name, "\n".join(bodies)
    sys.exit(f"{test}: no source")


def last_argument(text, start):
    """Of a call whose arguments begin at `start`."""
    depth, begin = 0, start
    for at in range(start, len(text)):
        if text[at] in "([{":
            depth += 1
        elif text[at] in ")]}":
            depth -= 1
            if depth < 0:
                return text[begin:at].strip()
        elif text[at] == "," and depth == 0:
            begin = at + 1
    return ""


def loosest(test, text):
    """The largest tolerance that a test asserts: of a difference, times what it is a share of, or of 1."""
    asserted = [last_argument(text, call.end()) for call in re.finditer(r"(?:EXPECT|ASSERT)_(?:NEAR|LT|LE)\(", text)]
    found = [re.match(r"([0-9.]+e-[0-9]+|0\.0[0-9]*)\b", argument) for argument in asserted]
    numbers = [float(match[1]) for match in found if match]
    numbers = numbers or [float(number) for number in re.findall(r"\(1 [+-] ([0-9.]+e-[0-9]+)\)", text)]
    if not numbers:
        sys.exit(f"{test}: neither a recorded number nor a tolerance")
    return max(numbers)


def error(value, exact):
    """Of a recorded number; of several, the last: that of the finest mesh."""
    number = float(value.split()[-1])
    return abs(number - exact) / (abs(exact) or 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="TEST_SOLVER")
    parser.add_argument("--small", action="store_true", help="a few of the rows only, to test this script")
    arguments = parser.parse_args()
    rows = ROWS[:3] + ROWS[25:30] if arguments.small else ROWS
    tests = results(arguments.program, sorted({row[2] for row in rows if not isinstance(row, str)}))
    lines = [HEAD]
    for row in rows:
        if isinstance(row, str):
            lines.append(f"\n## {row}\n\n| what | reference | test | error |\n|---|---|---|---:|")
            continue
        what, reference, test, name, exact = row
        matching = [found for full, found in tests.items() if re.fullmatch(test.replace("*", ".*"), full)]
        if not matching or any(found["result"] != "COMPLETED" for found in matching):
            sys.exit(f"{test}: did not run")
        file, text = source_of(test)
        if name is None:
            shown = f"at most {loosest(test, text):.0e}"
        elif name not in matching[0]:
            sys.exit(f"{test}: has not recorded {name}")
        else:
            shown = f"{error(matching[0][name], exact):.1e}"
        lines.append(f"| {what} | {reference} | `{file}` | {shown} |")
    PAGE.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
