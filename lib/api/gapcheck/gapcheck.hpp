#pragma once
// All of the public interface: audit a deck, read a run, compare, fix, run, follow the start of a run, write reports.
#include <gapcheck/arrays.hpp>
#include <gapcheck/audit.hpp>
#include <gapcheck/compare.hpp>
#include <gapcheck/fix.hpp>
#include <gapcheck/includes.hpp>
#include <gapcheck/mesh.hpp>
#include <gapcheck/read_motion.hpp>
#include <gapcheck/read_run.hpp>
#include <gapcheck/records.hpp>
#include <gapcheck/report.hpp>
#include <gapcheck/result.hpp>
#include <gapcheck/run.hpp>
#include <gapcheck/solver_run.hpp>
#include <gapcheck/version.hpp>
#include <gapcheck/start.hpp>
#include <gapcheck/write.hpp>
