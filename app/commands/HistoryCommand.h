// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace app {

/// `burin history FILE.burin [--json | --as-recipe | --report OUT.html|OUT.pdf [--force]]`: what
/// was done, as a table, as JSON, as a recipe that `burin run` takes, or as an audit report. The
/// file is only read; neither the study nor a display is needed.
int runHistory(const QStringList& arguments);

} // namespace app
