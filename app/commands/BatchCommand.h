// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/Command.h"

namespace app {

/// `burin batch RECIPE.json --studies LIST --into FOLDER [--jobs N] [--retries N] [--only NAME]
/// [--list | --table] [--force] …`: carries out a recipe on many studies, each by a `burin run` of
/// its own. Studies that are finished according to their record are skipped, whoever did them; so a
/// batch that was killed can be continued, and several may work on one folder. At the end it writes
/// the table of results. The exit status is 1 if any study failed.
extern const Command batchCommand;

} // namespace app
