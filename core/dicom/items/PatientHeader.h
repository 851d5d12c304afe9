// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/items/ConditionChain.h"

#include <tl/expected.hpp>

#include <QStringList>

#include <memory>

class DcmDataset;

namespace core {

/// A copy of a source's patient, study and frame-of-reference attributes that DCMTK will write:
/// UTF-8, invalid values normalised or, where that cannot be done, left out (dcmseg refuses to
/// write at all when a value copied from a source is not valid). Only for sources of core/dicom.
///
/// @param notes receives a sentence for each value that is not as in the source
/// @returns the error is the reason why no object may refer to this source
tl::expected<std::unique_ptr<DcmDataset>, QString> cleanPatientHeader(
    DcmDataset& source, QStringList& notes);

/// Adds, without values, what cleanPatientHeader() leaves out where the source has nothing and
/// every object must have (type 2).
void completePatientHeader(DcmDataset& set, ConditionChain& chain);

/// Text that DICOM can hold in a single value of at most @p length characters: no control
/// characters, no backslash, no blanks at the ends.
QString singleValueText(const QString& text, int length);

} // namespace core
