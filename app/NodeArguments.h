// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/Arguments.h"
#include "core/base/Result.h"
#include "core/pacs/PacsNode.h"

#include <QString>
#include <QStringList>

namespace app {

/// Options of every verb that talks to a node, beyond those of @p more.
[[nodiscard]] QStringList nodeOptions(const QStringList& more);

/// The node that the first word and the options of nodeOptions() name. InvalidField.
[[nodiscard]] core::Result<core::PacsNode> nodeOf(const Arguments& arguments);

} // namespace app
