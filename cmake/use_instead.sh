#!/bin/sh
# use_instead.sh COMMAND COMPILER ARGUMENT…: runs COMMAND with the arguments that were meant for COMPILER. CMake knows one
# compiler; as a launcher this gives a target another one.
command=$1
shift 2
exec $command "$@"
