// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/dicom/items/ConditionChain.h"
#include "core/titles/ReportSentence.h"

#include <tl/expected.hpp>

#include <QStringList>

#include <memory>

class DcmDataset;

namespace core {

/// A copy of a source's patient, study and frame-of-reference attributes in a form that DCMTK will
/// write: in UTF-8, with invalid values normalised or, if that is impossible, left out (dcmseg
/// refuses to write anything if a copied value is invalid). Only for sources of core/dicom.
///
/// @param notes receives a sentence for each value that differs from the source
/// @returns the error is the reason why no object may refer to this source
tl::expected<std::unique_ptr<DcmDataset>, Clause> cleanPatientHeader(
    DcmDataset& source, ReportLines& notes);

/// A patient's name and ID as cleanPatientHeader() keeps them; empty if it leaves them out.
[[nodiscard]] QString keptPatientName(const QString& name);
[[nodiscard]] QString keptPatientId(const QString& id);

/// Adds, without values, attributes that every object must have (type 2) and that
/// cleanPatientHeader() leaves out if the source lacks them.
void completePatientHeader(DcmDataset& set, ConditionChain& chain);

/// Text that DICOM can hold in a single value of at most @p length characters: no control
/// characters, no backslash, no blanks at the ends.
QString singleValueText(const QString& text, int length);

} // namespace core
