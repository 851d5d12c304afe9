// SPDX-License-Identifier: Apache-2.0
#include "app/commands/RunCommand.h"

#include "app/commands/RecipeRun.h"
#include "app/end/CommandTermination.h"
#include "app/steps/Arguments.h"
#include "app/steps/SessionTarget.h"
#include "app/steps/TracedRun.h"
#include "core/base/files/FileInUse.h"
#include "core/recipe/Recipe.h"

#include <QFileInfo>

namespace app {

namespace {

int runRecipe(const Arguments& arguments)
{
    if (arguments.rest().size() != 1)
        return reportUsageError("run", QStringLiteral("it needs one recipe"));
    if (const QString wrong = repairProblem(arguments); !wrong.isEmpty())
        return reportUsageError("run", wrong);
    if (arguments.has("facts"))
        reportFailuresAsFacts();
    const bool append = arguments.has("append");
    if (append && arguments.has("force"))
        return reportUsageError("run", QStringLiteral("--append and --force exclude each other"));
    if (append && (arguments.has("repair") || arguments.has("spacing")))
        return reportUsageError("run",
            QStringLiteral("--repair and --spacing are for a new session; one that goes on "
                           "keeps those that it was made with"));
    if (append && arguments.has("with-images"))
        return reportUsageError("run",
            QStringLiteral("--with-images is for a new session; one that goes on keeps what it "
                           "holds"));
    if (!append && !arguments.has("study"))
        return reportUsageError("run", QStringLiteral("--study is missing"));
    if (!arguments.has("session"))
        return reportUsageError("run", QStringLiteral("--session is missing"));
    const QString path = arguments.rest().first();
    const core::FileInUse recipeFile({path}, core::FileInUse::As::Recipe);
    // Of a folder it is known later which of its files are the study's.
    const QString study = arguments.value("study");
    const core::FileInUse studyFile(
        QFileInfo(study).isFile() ? QStringList{study} : QStringList(), core::FileInUse::As::Study);
    const core::Result<core::Recipe> recipe = core::readRecipe(path);
    if (!recipe) {
        const core::ErrorCode code = recipe.error().code;
        const bool namesFile = code == core::ErrorCode::FileNotFound
            || code == core::ErrorCode::FileUnreadable || code == core::ErrorCode::InvalidRecipe;
        return reportFailure(recipe.error(), namesFile ? QString() : path);
    }
    const core::Result<void> target =
        checkSessionTarget(arguments.value("session"), arguments.has("force"), append);
    if (!target)
        return reportFailure(target.error());
    CommandTermination termination;
    // What it has opened is closed before it is asked whether a signal came.
    const int status = RecipeRun(*recipe, arguments, termination).carryOut();
    return termination.status(status);
}

} // namespace

const Command runCommand{.name = "run",
    .words = "RECIPE.json",
    .usage = "RECIPE.json --study PATH [--series UID] [--repair REPAIRS]"
             " [--spacing COLUMNS,ROWS,SLICES] --session FILE.burin [--force | --append] "
             "[--with-images] [--apply-elsewhere] [--author NAME] [--facts] [--trace FILE.json]",
    .summary =
        "carries out a recipe without a window (burin edits lists what it can hold); --with-images "
        "puts the study's images, and with them who the patient is, into the session; --force "
        "replaces a session, which stays until the new one is whole; --repair, here and in info "
        "and open, says how the series is repaired on loading: tilt, spacing=even, gap=fill, "
        "gap=split:NUMBER, duplicates=first, duplicates=last, separated by commas, or none; "
        "--spacing says how many mm the voxels of PNG and TIFF pictures are apart",
    .options =
        std::vector<Option>{{"study", "PATH", "the study, as a file or folder"},
            {"session", "FILE.burin", "the session file in which every step is kept"},
            {"force", nullptr,
                "replaces a session, which stays until the new one is whole, and exported files"},
            {"append", nullptr, "goes on with a session that exists already"},
            {"with-images", nullptr,
                "puts the study's images, and with them who the patient is, into the session"},
            {"apply-elsewhere", nullptr,
                "allows a recipe that was made on another study, and skips what belongs to that "
                "study alone"},
            {"author", "NAME", "the name that stands in the audit trail"},
            {"facts", nullptr,
                "also prints, as lines of JSON, which study and graphics driver it is, and what "
                "kind a failure is"}}
        + seriesOptions() + spacingOption() + traceOption(),
    .run = [](const Arguments& arguments) { return traced(arguments, runRecipe); }};

} // namespace app
