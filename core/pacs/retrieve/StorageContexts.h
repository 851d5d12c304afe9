// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/pacs/Association.h"

#include <QByteArray>

#include <vector>

namespace core {

/// SOP classes that Burin opens, writes, or encounters in studies.
[[nodiscard]] const std::vector<QByteArray>& storageClasses();
/// Whether objects of a SOP class may be stored, as far as its UID shows: it is one of DICOM's
/// storage classes, known here or not, or of a manufacturer.
[[nodiscard]] bool mayBeStorage(const QByteArray& classUid);
/// Every transfer syntax in which Burin can read an object, the uncompressed ones first.
[[nodiscard]] const std::vector<QByteArray>& readableSyntaxes();

/// The contexts to propose so that a node sends objects of these classes unchanged: one context for
/// each compressed syntax, since a node would choose one syntax of a context and convert.
/// @param classes empty: storageClasses()
[[nodiscard]] std::vector<ProposedContext> retrieveContexts(std::vector<QByteArray> classes);

} // namespace core
