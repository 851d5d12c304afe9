// SPDX-License-Identifier: Apache-2.0
#include "ui/base/ErrorText.h"

#include "core/edits/kinds/surface/parts/SurfaceRules.h"
#include "core/recipe/RecipeStep.h"
#include "ui/texts/ClauseText.h"
#include "ui/texts/SessionTexts.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <vector>

namespace ui {

namespace {

struct ErrorTexts {
    Q_DECLARE_TR_FUNCTIONS(ui::ErrorText)
};

/// Whether it is said of an edit, or a walk through the history, as a whole.
bool isStep(const QString& name)
{
    const std::vector<core::EditDocumentation> steps = core::recipeStepDocumentation();
    return std::any_of(
        steps.begin(), steps.end(), [&name](const auto& step) { return step.name == name; });
}

/// A reason behind a colon; nothing without one.
QString behind(const QString& reason)
{
    return reason.isEmpty() ? QString() : QStringLiteral(": ") + reason;
}

QString sentenceOf(const core::Error& error)
{
    using core::ErrorCode;
    const QString first = clauseText(error.arguments.value(0));
    const QString second = clauseText(error.arguments.value(1));
    const QString third = clauseText(error.arguments.value(2));
    const QString reason = behind(second);
    switch (error.code) {
    case ErrorCode::FileNotFound:
        return ErrorTexts::tr("%1: no such file or folder").arg(first);
    case ErrorCode::FileUnreadable:
        return ErrorTexts::tr("%1: cannot be read%2").arg(first, reason);
    case ErrorCode::FileTruncated:
        return ErrorTexts::tr("%1: the file is cut short%2").arg(first, reason);
    case ErrorCode::FileExists:
        return ErrorTexts::tr("%1: exists already; --force replaces it").arg(first);
    case ErrorCode::FileUnwritable:
        return ErrorTexts::tr("%1: cannot be written%2").arg(first, reason);
    case ErrorCode::FolderEmpty:
        return ErrorTexts::tr("%1: the folder is empty").arg(first);
    case ErrorCode::TooManyFiles:
        return ErrorTexts::tr("%1: more than %2 files lie in this folder; name the study's own")
            .arg(first, second);
    case ErrorCode::NoImages:
        return ErrorTexts::tr("%1: holds no image volume%2").arg(first, reason);
    case ErrorCode::UnsupportedFormat:
        return ErrorTexts::tr("%1: not supported%2").arg(first, reason);
    case ErrorCode::InvalidGeometry:
        return ErrorTexts::tr("%1: the slices do not form a volume%2").arg(first, reason);
    case ErrorCode::SeriesAmbiguous:
        return ErrorTexts::tr("%1: holds more than one series; choose one with --series:\n  %2")
            .arg(first, error.arguments.mid(1).join(QStringLiteral("\n  ")));
    case ErrorCode::SeriesNotFound:
        return ErrorTexts::tr("%1: no such series%2").arg(first, reason);
    case ErrorCode::UnknownEdit:
        return ErrorTexts::tr("unknown edit '%1'%2").arg(first, reason);
    case ErrorCode::InvalidField:
        if (first == QLatin1String(core::crossingSurface))
            return ErrorTexts::tr("the surface passes through itself at %1 pairs of faces, and "
                                  "nothing was changed: use Refine > Lay crossing parts anew, "
                                  "smooth it there, or lay it again")
                .arg(second);
        if (first == QLatin1String("repair"))
            return third.isEmpty() ? second : ErrorTexts::tr("%1: %2").arg(third, second);
        return isStep(first) ? first + reason : ErrorTexts::tr("field '%1'%2").arg(first, reason);
    case ErrorCode::SegmentLocked:
        return first.isEmpty() ? ErrorTexts::tr("every segment is locked")
                               : ErrorTexts::tr("segment '%1' is locked").arg(first);
    case ErrorCode::SegmentProtected:
        return ErrorTexts::tr("segment '%1' is protected from sculpting").arg(first);
    case ErrorCode::SeedsStay:
        return ErrorTexts::tr(
            "nothing was taken back: %1 of the sketched voxels %2, and those are not taken back; "
            "sketch beside them, or erase them first")
            .arg(first,
                first == QLatin1String("1") ? ErrorTexts::tr("is a seed or was painted")
                                            : ErrorTexts::tr("are seeds or were painted"));
    case ErrorCode::NothingGrown:
        return ErrorTexts::tr("nothing was taken back: no growth came through the sketched places");
    case ErrorCode::EverythingGrown:
        return ErrorTexts::tr("nothing was taken back: so far back, all that has grown would go; "
                              "take fewer generations, or shrink to the seeds");
    case ErrorCode::NoIslandThere:
        return ErrorTexts::tr("segment '%1' has no voxel at that place").arg(first);
    case ErrorCode::TooManyIslands:
        return ErrorTexts::tr("segment '%1' has %2 islands beside the largest, and there can be %3 "
                              "segments more; with a larger minimum small islands stay with it")
            .arg(first, second, third);
    case ErrorCode::StepsEntangled:
        return ErrorTexts::tr("cannot undo only that: %1").arg(first);
    case ErrorCode::SeedOutsideVolume:
        return ErrorTexts::tr("seed outside the volume: %1%2").arg(first, reason);
    case ErrorCode::UnknownSegment:
        return ErrorTexts::tr("there is no segment %1%2").arg(first, reason);
    case ErrorCode::InvalidRecipe:
        return ErrorTexts::tr("%1: not a recipe%2").arg(first, reason);
    case ErrorCode::ExportMismatch:
        return ErrorTexts::tr("%1: the export was checked and does not agree%2").arg(first, reason);
    case ErrorCode::SegmentNotCoded:
        return ErrorTexts::tr("segment '%1' is not coded yet; DICOM SEG and SR need that")
            .arg(first);
    case ErrorCode::NothingToExport:
        return ErrorTexts::tr("%1: nothing to export%2").arg(first, reason);
    case ErrorCode::SessionDamaged:
        return ErrorTexts::tr("%1: the session is damaged%2").arg(first, behind(damageText(error)));
    case ErrorCode::SessionUnwritten:
        return ErrorTexts::tr(
            "%1 cannot be written now%2. Work goes on and is kept in memory; it is "
            "written as soon as that is possible")
            .arg(first, reason);
    case ErrorCode::SessionMoved:
        return ErrorTexts::tr("the session goes on in %1%2. Nothing is lost").arg(first, reason);
    case ErrorCode::SessionMismatch:
        return ErrorTexts::tr("%1: the session was made on another volume%2").arg(first, reason);
    case ErrorCode::SessionReadOnly:
        return ErrorTexts::tr("%1 is open for looking only%2. 'Save session as …' gives a copy "
                              "that can be edited")
            .arg(first, reason);
    case ErrorCode::StudyMissing:
        return ErrorTexts::tr("%1: its study is no longer at %2%3; name it with --study")
            .arg(first, second,
                error.arguments.size() > 2
                    ? ErrorTexts::tr(", and its own images cannot be used (%1)").arg(third)
                    : QString());
    case ErrorCode::NodeUnreachable:
        return ErrorTexts::tr("%1 cannot be reached%2").arg(first, reason);
    case ErrorCode::NodeRejects:
        return ErrorTexts::tr("%1 does not talk to us%2").arg(first, reason);
    case ErrorCode::NodeRefuses:
        return ErrorTexts::tr("%1 does not support %2").arg(first, second);
    case ErrorCode::NodeTimeout:
        return error.arguments.size() > 2
            ? ErrorTexts::tr("%1 is given up after %2 s: %3").arg(first, second, third)
            : ErrorTexts::tr("%1 does not answer; %2 s without a sign of life").arg(first, second);
    case ErrorCode::NodeLost:
        return ErrorTexts::tr("%1 ended the connection before all was done%2").arg(first, reason);
    case ErrorCode::NodeNonsense:
        return ErrorTexts::tr("%1 does not speak DICOM%2").arg(first, reason);
    case ErrorCode::NodeFailed:
        return ErrorTexts::tr("%1 could not carry out %2: %3").arg(first, second, third);
    case ErrorCode::NodeHasNone:
        return ErrorTexts::tr("%1 holds no such %2").arg(first, second);
    case ErrorCode::TransferIncomplete:
        return ErrorTexts::tr("%1: %2 images did not arrive%3; what is here is kept, the same "
                              "command goes on from there")
            .arg(first, second,
                error.arguments.size() > 2 ? QStringLiteral(" (%1)").arg(third) : QString());
    case ErrorCode::GraphicsUnavailable:
        return ErrorTexts::tr("no OpenGL 4.5 available: %1%2").arg(first, reason);
    case ErrorCode::OutOfMemory:
        return ErrorTexts::tr("not enough memory: %1").arg(first);
    case ErrorCode::EngineLost:
        return ErrorTexts::tr(
            "the graphics processor failed (%1); close the study and open it again: "
            "every step so far is in its session")
            .arg(first);
    case ErrorCode::ContextLost:
        return ErrorTexts::tr("the graphics driver broke off its work (%1); every step so far is "
                              "in its session, which opens again where it stood")
            .arg(first);
    case ErrorCode::Cancelled:
        return ErrorTexts::tr("cancelled");
    case ErrorCode::Internal:
        return ErrorTexts::tr("internal error: %1%2").arg(first, reason);
    }
    return {};
}

} // namespace

QString errorText(const core::Error& error)
{
    const QString sentence = sentenceOf(error);
    const QString entry = core::givesNoReason(error.code)
        ? clauseText(error.arguments.value(core::entryArgument))
        : QString();
    return entry.isEmpty() ? sentence : sentence + QLatin1Char(' ') + entry;
}

QString noFileText(const core::Error& why)
{
    // The file's own name says nothing to anybody.
    const QString folder = QFileInfo(why.arguments.value(0)).absolutePath();
    const QString reason = QFileInfo::exists(folder) ? clauseText(why.arguments.value(1))
                                                     : ErrorTexts::tr("it cannot be made");
    return ErrorTexts::tr("sessions cannot be written to %1 (%2)").arg(folder, reason);
}

} // namespace ui
