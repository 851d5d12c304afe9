// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/labels/EditableVoxels.h"

#include <algorithm>

namespace core {

namespace {

bool planesAreSound(const std::vector<EditableVoxels::PlaneLabels>& listed)
{
    std::bitset<256> planes;
    return std::all_of(
        listed.begin(), listed.end(), [&planes](const EditableVoxels::PlaneLabels& each) {
            const bool isNew = !planes.test(each.plane);
            planes.set(each.plane);
            return isNew && !each.labels.test(0);
        });
}

} // namespace

Result<void> checkSound(const std::optional<EditableVoxels>& editable)
{
    if (!editable)
        return {};
    if ((editable->inside && !planesAreSound(*editable->inside))
        || !planesAreSound(editable->outside))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("editable"), Clause::saying("is not sound"));
    return {};
}

} // namespace core
