// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/items/ConditionChain.h"
#include "core/dicom/source/SegSource.h"
#include "core/dicom/write/SegWriter.h"

#include <memory>
#include <string>

class DcmDataset;

namespace core {

// Corrects in a finished data set what dcmseg 3.6.7 cannot write or writes incorrectly: text beyond
// ASCII, the bits, numbers of referenced frames. Only for sources of core/dicom.

/// Replaces text until completeSeg(), since dcmseg accepts only ASCII, whatever the character set.
std::string placeholder(const QString& text);

/// A copy of the source's header with placeholders for text.
std::unique_ptr<DcmDataset> placeholderHeader(DcmDataset& header);

QString seriesDescription(const SegContent& content);
QString segmentLabel(const Segment& segment);

void completeSeg(
    DcmDataset& dataset, const SegContent& content, const SegSource& source, ConditionChain& chain);

} // namespace core
