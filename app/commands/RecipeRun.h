// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/SessionPlan.h"
#include "app/steps/SteadySession.h"
#include "core/base/files/FileInUse.h"
#include "core/base/files/FollowedFile.h"
#include "core/recipe/Recipe.h"
#include "core/recipe/RecipeElsewhere.h"
#include "core/sessionfile/records/SessionContents.h"

#include <optional>
#include <vector>

namespace app {

class Arguments;
class CommandTermination;

/// One run of `burin run`: opens the study and the session, carries out the recipe's steps, and
/// writes its exports. It prints its reports as it goes. Use it once.
class RecipeRun {
public:
    /// @param arguments those of `burin run`, already checked; must outlive this, as
    /// @p termination
    RecipeRun(core::Recipe recipe, const Arguments& arguments, CommandTermination& termination);

    /// @return the exit status of the command
    [[nodiscard]] int carryOut();

private:
    // The parts of carryOut(), in this order.
    // @return the exit status if the command ends here; none: it goes on
    [[nodiscard]] std::optional<int> openStudy();
    [[nodiscard]] std::optional<int> prepareRecipe();
    [[nodiscard]] std::optional<int> openSession();
    [[nodiscard]] std::optional<int> carryOutSteps();
    [[nodiscard]] std::optional<int> replaceOlder();
    [[nodiscard]] int exportAndClose();

    /// Whether the recipe can be carried out from a document on.
    [[nodiscard]] core::Result<void> checkAgainst(const core::Document& document) const;
    [[nodiscard]] core::Result<core::LoadedVolume> load() const;
    /// Reads the study of a session again.
    [[nodiscard]] core::Result<core::LoadedVolume> readStudy(const QString& session) const;
    [[nodiscard]] core::Result<SteadySession::Session> openFirst(gpu::GpuEngine& engine);
    [[nodiscard]] core::Result<SteadySession::Session> openAgain(gpu::GpuEngine& engine);
    /// Names the author of the rows of a session, and follows its file if another program renames
    /// it.
    void follow(core::EditSession& session);
    [[nodiscard]] int giveUp(const core::Error& why, std::size_t rowsBefore);

    core::Recipe m_recipe;
    const Arguments& m_arguments;
    CommandTermination& m_termination;
    QString m_file; ///< of the session, as the user has named it
    bool m_force = false;
    /// A session that is to be replaced stays until the new one is whole.
    bool m_replaces = false;
    QString m_place; ///< where the session is made
    QString m_repair; ///< of the series, if the recipe was recorded on a repaired one
    /// of the session that is continued; none: a new one
    std::optional<core::SessionContents> m_goesOn;
    core::Result<core::LoadedVolume> m_loaded; ///< handed over to the session
    core::SessionSource m_source;
    std::optional<core::FileInUse> m_sources;
    std::optional<core::FileInUse> m_masks;
    /// Set if the recipe was recorded on another study.
    std::optional<core::RecipeElsewhere> m_elsewhere;
    std::vector<core::RecipeElsewhere::LeftOut> m_leftOut;
    SessionPlan m_plan; ///< for a session that is continued
    QString m_openFile; ///< the session's file, whether it is open or closed
    core::FollowedFile m_made; ///< that file
    bool m_isFirst = true; ///< nothing was opened yet
    SteadySession m_steady; ///< last: while it closes, its session uses some of the above
};

} // namespace app
