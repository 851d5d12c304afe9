// SPDX-License-Identifier: Apache-2.0
#include "core/edits/answers/EditChecks.h"

#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"

namespace core {

Result<void> checkLayer(const char* field, int id, const Document& document)
{
    const SculptLayer* layer = document.layer(id);
    if (!layer)
        return failure(ErrorCode::InvalidField, QLatin1String(field),
            Clause::saying("there is no sculpt layer %1", id));
    if (const Clause why = document.whyItDoesNotCarve(*layer); !why.isEmpty())
        return failure(ErrorCode::InvalidField, QLatin1String(field),
            Clause::saying(
                "sculpt layer '%1' %2: what is carved there would not be seen", layer->name, why));
    return {};
}

Result<void> checkEditable(int label, const std::optional<EditableRange>& range,
    const Document& document, const char* edit)
{
    if (const auto editable = editableVoxels(range, document, edit); !editable)
        return tl::unexpected(editable.error());
    return discardValue(segmentTarget(label, false, document));
}

} // namespace core
