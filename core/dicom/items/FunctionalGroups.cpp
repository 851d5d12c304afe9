// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/items/FunctionalGroups.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

FunctionalGroups::FunctionalGroups(DcmItem& dataSet)
    : m_dataSet(dataSet)
{
    if (dataSet.findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, m_shared).bad())
        m_shared = nullptr;
    DcmSequenceOfItems* frames = nullptr;
    if (dataSet.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, frames).bad())
        return;
    m_perFrame.reserve(frames->card());
    for (DcmObject* item = frames->nextInContainer(nullptr); item != nullptr;
         item = frames->nextInContainer(item))
        m_perFrame.push_back(dynamic_cast<DcmItem*>(item));
}

DcmItem* FunctionalGroups::find(const DcmTagKey& macro, std::size_t frame) const
{
    DcmItem* item = nullptr;
    DcmItem* own = frame < m_perFrame.size() ? m_perFrame[frame] : nullptr;
    if (own != nullptr && own->findAndGetSequenceItem(macro, item).good())
        return item;
    if (m_shared != nullptr && m_shared->findAndGetSequenceItem(macro, item).good())
        return item;
    return nullptr;
}

DcmItem& FunctionalGroups::holder(const DcmTagKey& macro, std::size_t frame) const
{
    DcmItem* item = find(macro, frame);
    return item != nullptr ? *item : m_dataSet;
}

} // namespace core
