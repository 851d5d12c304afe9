// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin batch RECIPE.json --studies LIST --into FOLDER [--jobs N] [--retries N] [--only NAME]
/// [--list | --table] [--force] …`: a recipe over many studies, each by a `burin run` of its own.
/// What a record says is finished is not done again, whoever did it; so a batch that was killed
/// goes on, and several may work on one folder. Ends with 1 if any study failed, and writes the
/// table of results.
extern const Command batchCommand;

} // namespace app
