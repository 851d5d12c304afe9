// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/pacs/Association.h"

#include <QByteArray>

#include <vector>

namespace core {

/// Kinds of objects that Burin opens, writes, or meets beside them.
[[nodiscard]] const std::vector<QByteArray>& storageClasses();
/// Every transfer syntax in which Burin can read an object, the uncompressed ones first.
[[nodiscard]] const std::vector<QByteArray>& readableSyntaxes();

/// What to propose so that a node sends objects of these kinds as it has them: a context for each
/// compressed syntax, since of the syntaxes of one context it would choose, and convert.
/// @param classes empty: storageClasses()
[[nodiscard]] std::vector<ProposedContext> retrieveContexts(std::vector<QByteArray> classes);

} // namespace core
