// SPDX-License-Identifier: Apache-2.0
#include "app/window/SessionOpening.h"

#include "core/session/SessionStorage.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/records/SessionContents.h"
#include "gpu/engine/GpuEngine.h"

#include <QFileInfo>

#include <utility>

namespace app {

std::shared_ptr<SessionOpening> SessionOpening::make(
    gpu::GpuEngine& engine, core::LoadedVolume loaded, const Wish& wish)
{
    auto opening = std::make_shared<SessionOpening>();
    opening->file = wish.file;
    opening->contents = wish.contents;
    opening->notFromStudy = loaded.notFromStudy;
    if (engine.isContextLost()) {
        if (const core::Result<void> renewed = engine.renew(); !renewed) {
            opening->session = tl::unexpected(renewed.error());
            return opening;
        }
    }
    if (!opening->contents && QFileInfo::exists(wish.file)) {
        auto contents = core::checkSession(wish.file);
        if (!contents) {
            opening->session = tl::unexpected(contents.error());
            return opening;
        }
        opening->contents = std::make_shared<const core::SessionContents>(*std::move(contents));
    }
    if (opening->contents) {
        const auto plan = planFor(wish.file, *opening->contents, wish.redo);
        if (!plan) {
            opening->session = tl::unexpected(plan.error());
            return opening;
        }
        opening->plan = *plan;
        opening->file = plan->file;
    }
    engine.setVolumeGeometry(loaded.volume.geometry, loaded.volume.encoding);
    // A study opens, even where no step of it can be written.
    opening->session = opening->plan
        ? openPlanned(engine.edits(), std::move(loaded), *opening->plan, wish.wakeUp)
        : core::EditSession::create(engine.edits(), std::move(loaded),
            {.file = wish.file, .beginWithoutFile = true, .wakeUp = wish.wakeUp});
    opening->opened = core::FollowedFile(opening->file);
    return opening;
}

SessionOpening::~SessionOpening()
{
    if (!session || !*session)
        return;
    const bool madeForIt = plan ? plan->isNew : !(*session)->storage().whyNoFile();
    session->reset();
    // It may have waited for a dialog, and another program may have put another file in its place.
    if (madeForIt && opened.isAt(file))
        core::removeSession(file);
}

} // namespace app
