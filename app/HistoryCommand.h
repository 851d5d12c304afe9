// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace app {

/// `burin history FILE.burin [--json | --as-recipe]`: what was done, as a table, as JSON, or as a
/// recipe that `burin run` takes. The file is only read; the study is not needed.
int runHistory(const QStringList& arguments);

} // namespace app
