# Suites whose tests share results that take seconds: one process each.
set(RICOCHET_SUITES_TOGETHER ReproductionResults Results)
list(TRANSFORM RICOCHET_SUITES_TOGETHER APPEND ".*" OUTPUT_VARIABLE together)

# Tests that take more than three seconds of a core, or wait as long, each with quick ones beside it; ./ricochet test leaves them
# out, ./ricochet test --all does not.
set(RICOCHET_SLOW_TESTS
  # the machine: exhaustive scans, brute force, long simulations
  BruteForce.* PlanarBruteForce.* HostileScene.WithMoreThanAMillionStepsIsGivenUp *WithAnImpossibleControlEnds*
  *HasTheThresholdOfAnExhaustiveScan* Staircase.DoesNotHangOnWhereTheScanEnds
  Regimes.MissNoneThatAnEvenScanFinds Regimes.AreNotCertainAmongIrregularMotions
  Regimes.CountWhatFewPhasesOfADisturbanceHave
  ShapeDerivatives.OfSecondOrderAreThoseOfDualNumbers Race.HasTheSuitesSolutionAsItsGoalWhateverTheSeed
  HockSchittkowskiTolerance.*
  # solvers
  Varied.AsksForTheSame* Varied.MakesAnotherRunWithEveryOption Varied.RefusesWhatThisIpoptWasBuiltWithout
  *DeclaredCapabilities.*/dlib_global_search *DeclaredCapabilities.*/ipopt* Plugin.IsRefusedWhereLoadingItNeverEnds
  *DirectComparison*/ipopt* *AtLimitContract*/continuation_ipopt_tuned *DerivativeIsNotFinite/*ipopt*
  LineProgram.IsReportedWhileItIsWaitedForNoLongerThanItIsTold
  # stores
  ArchiveFile.IsRefusedIfAStrangerMadeItOtherwise ForgedStores.AreRefusedWhereTheyContradictWhatIsKnown
  # studies
  IdentifiedMachine.IsFoundThroughFaultsOfTheMeasurement IdentifiedMachine.SaysWhatARecordContradicts
  SimulatorsStudy.FillsItsPage HardSearch.FoundTheFastestQuietSpeedBeyondLoudOnes
  ${together}
  # commands
  Bench.* CampaignCommands.KeepAMachineOfTheUsersInTheStore
  EditedSolver.* Golden.IsWhatIsPrinted/export Identify.HasNoIntervals* Identify.FindsTheMachineOfTheExample
  Main.NeedsNoStandardError Main.SendsEscapesOnlyToATerminalThatTakesThem DailyUse.NoticesThatItsFolderIsGone
  Reproduce.WritesAReportThatStandsAlone Simulators.ComparesAToolOfOnesOwn
  StrangersFolder.IsNoSiteWhereItsPagesAreLinks StrangersFolder.IsWrittenOnlyAsFilesOfItsOwn
  StrangersFolder.IsNoPlaceToGoOnWhereItsFilesAreLinks
  TimeLimit.SaysWhatSimulationAloneTellsOfTheRest TimeLimit.SaysInJsonWhatIsNotComplete Verify.*)

# What the sanitizers do without, beside these: endless and repeated runs, whose parts are tested too; comparisons with
# libraries; and Ipopt in the contracts of all solvers, for its large blocks of memory take most of their time there.
set(RICOCHET_TESTS_NOT_SANITIZED
  *Contract.*ipopt* *DirectComparison* *WhatTheLibraryReturns* *AsksTheSameWhereverItsMemoryLies*
  *MethodsEndWithAReason* QuietSpeed.IsTheSameWhereverTheRangeEnds
  HardSearch.JudgesAMachineAsItsFileSays *HasConverged/nlopt_direct*
  *DeclaredCapabilities.* *GivesTheSameTraceForTheSameRun* *GivesTheSameTracesInTwoThreads*
  Varied.GivesIpoptItsOwnOptions */dlib_global_search *Adapters.ReachTheseOptima/ipopt
  QuietSpeed.IsTheEndOfTwoCollisionsATurnInTheLongRun QuietSpeed.IsMissingWhereEverySpeedIsLoud
  CompleteScan.HoldsAtEverySpeedLookedAt Trust.ReachesToWhereTheMotionChanges
  ShapeDerivatives.AreThoseOfDualNumbers Derivatives.OfSecondOrderAreThoseOfDifferencesOfTheFirst
  MachineGrid.AsksOfEveryCombinationWhatItSays Varied.TellsWhatIsUsual
  Continuation.FindsTheEndOfAPlateauThatItsSolverMisses
  QuietRule.GivesTheWindowTheBorderOfTheLongRun Regimes.HaveBordersThatLongSimulationsBracket
  Regimes.OfADisturbedMachineBeginAgainAfterABorder)
