// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/segments/ImportOperation.h"

#include "core/edits/document/DocumentEdits.h"

#include <utility>

namespace core {

ImportOperation::ImportOperation(ImportMask edit, RowId again)
    : WorkedOutOperation(std::move(edit), Kind::Whole, again)
{
}

bool ImportOperation::foresee(Document& document) const
{
    return bool(applyToDocument(edit(), document));
}

void ImportOperation::start(SessionState& state)
{
    if (!mayStart(state))
        return;
    const auto& mask = edit().get<ImportMask>();
    Result<ImportPlan> plan = importPlan(mask, state.document);
    if (!plan)
        return giveUp(state, plan.error());
    // Its voxels are packed bytes, which copies share.
    workAside(state,
        [this, watch = watch(), segments = *mask.segments,
            plan = std::make_shared<ImportPlan>(*std::move(plan))] {
            auto labels = std::make_shared<Result<LabelPlanes>>(
                labelPlanes(*plan, segments, watch->progress));
            return SideThread::Sequel([this, labels](SessionState& known) {
                if (!*labels)
                    return giveUp(known, labels->error());
                write(known, Listed(**std::move(labels)));
            });
        });
}

void ImportOperation::takeResult(SessionState& state, EngineResult&& result)
{
    takeWritten(state, std::move(result));
}

} // namespace core
