// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/items/ConditionChain.h"
#include "core/dicom/source/SegSource.h"
#include "core/document/Document.h"

#include <QString>

#include <string>
#include <vector>

class DcmItem;
class DcmTagKey;

namespace core {

/// Writes attributes of DICOM items as plain data; what goes wrong is in the chain. Items that
/// could not be made are null and take everything. Only for sources of core/dicom.
class ItemWriter {
public:
    explicit ItemWriter(ConditionChain& chain)
        : m_chain(chain)
    {
    }

    /// A new item at the end of a sequence, which is made where it is missing.
    DcmItem* append(DcmItem* parent, const DcmTagKey& sequence) const;
    void put(DcmItem* item, const DcmTagKey& tag, const std::string& value) const;
    void put(DcmItem* item, const DcmTagKey& tag, const QString& value) const;
    void put(DcmItem* item, const DcmTagKey& tag, const char* value) const;
    /// US
    void putWord(DcmItem* item, const DcmTagKey& tag, int value) const;
    /// A sequence of one item that holds a code.
    void putCode(DcmItem* item, const DcmTagKey& sequence, const CodedConcept& code) const;
    /// SOP class, instance and, of a file of several, frame.
    void refer(DcmItem* item, const SegSlice& slice) const;
    /// Every image of the slices once: an item of @p seriesSequence for each series, in it one of
    /// @p imageSequence for each image.
    void referAll(DcmItem* parent, const DcmTagKey& seriesSequence, const DcmTagKey& imageSequence,
        const std::vector<SegSlice>& slices) const;

private:
    ConditionChain& m_chain;
};

/// Whether DICOM can hold a code: scheme and value of 1 to 16 characters, ASCII, meaning 1 to 64.
[[nodiscard]] bool fitsCodeSequence(const CodedConcept& code);

} // namespace core
