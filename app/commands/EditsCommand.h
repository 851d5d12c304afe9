// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace app {

/// `burin edits [--json]`: what a recipe can hold, from the schema that parses it.
int runEdits(const QStringList& arguments);

} // namespace app
