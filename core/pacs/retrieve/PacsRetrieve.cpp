// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/retrieve/PacsRetrieve.h"

#include "core/pacs/Association.h"
#include "core/pacs/NodeStatus.h"
#include "core/pacs/PacsQuery.h"
#include "core/pacs/retrieve/DownloadFolder.h"
#include "core/pacs/retrieve/MoveListener.h"
#include "core/pacs/retrieve/ObjectIntake.h"
#include "core/pacs/retrieve/RetrievePlan.h"
#include "core/pacs/retrieve/StorageContexts.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmnet/dimse.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace core {

namespace {

/// The identifiers of the requests that fetch what is missing of a series.
std::vector<std::unique_ptr<DcmDataset>> identifiers(
    const RetrievePlan& plan, const RetrievePlan::Series& series)
{
    constexpr qsizetype mostUids = 200;
    std::vector<std::unique_ptr<DcmDataset>> all;
    const auto add = [&](const char* level) -> DcmDataset& {
        auto set = std::make_unique<DcmDataset>();
        set->putAndInsertString(DCM_QueryRetrieveLevel, level);
        set->putAndInsertString(DCM_StudyInstanceUID, plan.studyUid.toLatin1().constData());
        set->putAndInsertString(DCM_SeriesInstanceUID, series.seriesUid.toLatin1().constData());
        all.push_back(std::move(set));
        return *all.back();
    };
    if (series.asWhole()) {
        add("SERIES");
        return all;
    }
    for (qsizetype at = 0; at < series.missing.size(); at += mostUids) {
        const QString uids = series.missing.mid(at, mostUids).join(QLatin1Char('\\'));
        add("IMAGE").putAndInsertString(DCM_SOPInstanceUID, uids.toLatin1().constData());
    }
    return all;
}

/// How requests ended, beyond what did arrive.
struct Conclusion {
    std::uint16_t status = 0; ///< the first that is no success
    int failed = 0; ///< objects, as the node counts them

    template <class Response> void add(const Response& response, bool tellsFailed)
    {
        if (status == 0)
            status = response.DimseStatus;
        if (tellsFailed)
            failed += response.NumberOfFailedSubOperations;
    }
};

/// A request under way: takes what comes until the node has said its last word on it. One that says
/// again and again that it is at work, and sends nothing of an object, is given up.
/// @param stores the node stores on this association
Result<void> follow(
    Association& association, ObjectIntake& intake, bool stores, Conclusion& conclusion)
{
    const PacsNode& node = association.node();
    const Patience::Seconds longest = Patience::ofQuestion(node.timeoutSeconds);
    auto lastPiece = Patience::Clock::now();
    std::int64_t known = intake.pieces();
    for (;;) {
        const std::int64_t pieces = intake.pieces();
        if (std::exchange(known, pieces) != pieces)
            lastPiece = Patience::Clock::now();
        if (Patience::Clock::now() - lastPiece > longest)
            return failure(ErrorCode::NodeTimeout, node.name(), QString::number(longest.count()),
                Clause::saying("it says that it is at work, and sends nothing"));
        std::uint8_t context = 0;
        const Result<T_DIMSE_Message> message = association.receive(context);
        if (!message)
            return tl::unexpected<Error>(message.error());
        if (message->CommandField == DIMSE_C_STORE_RQ && stores) {
            Result<void> taken = intake.take(association, context, message->msg.CStoreRQ);
            if (!taken)
                return taken;
            continue;
        }
        const bool isGet = message->CommandField == DIMSE_C_GET_RSP;
        if (!isGet && message->CommandField != DIMSE_C_MOVE_RSP) {
            return failure(ErrorCode::NodeNonsense, node.name(), Clause::saying("no answer"));
        }
        const T_DIMSE_C_GetRSP& get = message->msg.CGetRSP;
        const T_DIMSE_C_MoveRSP& move = message->msg.CMoveRSP;
        const auto hasData = isGet ? get.DataSetType : move.DataSetType;
        if (hasData != DIMSE_DATASET_NULL) {
            Result<void> ignored =
                association.receiveData(context, [](const char*, std::size_t) {});
            if (!ignored)
                return ignored;
        }
        if (DICOM_PENDING_STATUS(isGet ? get.DimseStatus : move.DimseStatus))
            continue;
        if (isGet)
            conclusion.add(get, (get.opts & O_GET_NUMBEROFFAILEDSUBOPERATIONS) != 0);
        else
            conclusion.add(move, (move.opts & O_MOVE_NUMBEROFFAILEDSUBOPERATIONS) != 0);
        return {};
    }
}

T_DIMSE_Message getRequest(std::uint16_t id, const QByteArray& model)
{
    T_DIMSE_Message request{};
    request.CommandField = DIMSE_C_GET_RQ;
    T_DIMSE_C_GetRQ& get = request.msg.CGetRQ;
    get.MessageID = id;
    std::strcpy(get.AffectedSOPClassUID, model.constData());
    get.Priority = DIMSE_PRIORITY_MEDIUM;
    get.DataSetType = DIMSE_DATASET_PRESENT;
    return request;
}

T_DIMSE_Message moveRequest(std::uint16_t id, const QByteArray& model, const PacsNode& node)
{
    T_DIMSE_Message request{};
    request.CommandField = DIMSE_C_MOVE_RQ;
    T_DIMSE_C_MoveRQ& move = request.msg.CMoveRQ;
    move.MessageID = id;
    std::strcpy(move.AffectedSOPClassUID, model.constData());
    move.Priority = DIMSE_PRIORITY_MEDIUM;
    move.DataSetType = DIMSE_DATASET_PRESENT;
    std::strcpy(move.MoveDestination, node.ownAeTitle.toLatin1().constData());
    return request;
}

Result<Conclusion> fetch(const PacsNode& node, const RetrievePlan& plan, ObjectIntake& intake,
    const RetrieveWay& way, const Progress& progress)
{
    const QByteArray model = way.movePort ? UID_MOVEStudyRootQueryRetrieveInformationModel
                                          : UID_GETStudyRootQueryRetrieveInformationModel;
    std::vector<ProposedContext> contexts{{model, plainSyntaxes()}};
    if (!way.movePort) {
        for (ProposedContext& context : retrieveContexts(plan.classes()))
            contexts.push_back(std::move(context));
    }
    Result<Association> association = Association::request(node, contexts, progress);
    if (!association)
        return tl::unexpected<Error>(association.error());
    const Result<std::uint8_t> context = association->context(model);
    if (!context)
        return tl::unexpected<Error>(context.error());
    std::unique_ptr<MoveListener> listener;
    if (way.movePort) {
        // Nodes need not say on this connection that they are at work (PS3.4 C.4.2.3): what comes
        // on the other one says it.
        intake.setOnPiece([&control = *association] { control.notePassed(); });
        Result<std::unique_ptr<MoveListener>> listening =
            MoveListener::start(node, *way.movePort, intake);
        if (!listening)
            return tl::unexpected<Error>(listening.error());
        listener = std::move(*listening);
    }
    Conclusion conclusion;
    for (const RetrievePlan::Series& series : plan.series) {
        if (series.isHere())
            continue;
        for (const std::unique_ptr<DcmDataset>& identifier : identifiers(plan, series)) {
            const std::uint16_t id = association->nextMessageId();
            T_DIMSE_Message request =
                way.movePort ? moveRequest(id, model, node) : getRequest(id, model);
            Result<void> done = association->send(*context, request, identifier.get());
            if (done)
                done = follow(*association, intake, !listener, conclusion);
            if (!done)
                return tl::unexpected<Error>(done.error());
        }
    }
    association->release();
    if (listener) {
        if (const std::optional<Error> trouble = listener->stop())
            return tl::unexpected<Error>(*trouble);
    }
    return conclusion;
}

/// @param total of objects; 0: nobody could list them before
tl::unexpected<Error> incomplete(
    const PacsNode& node, const ObjectIntake& intake, const Conclusion& conclusion, qsizetype total)
{
    const qsizetype missing =
        std::max({qsizetype(1), intake.missing().size(), qsizetype(conclusion.failed)});
    if (!intake.refusal() && conclusion.status != 0 && intake.received() == 0) {
        return failure(ErrorCode::NodeFailed, node.name(), Clause::saying("the download"),
            statusText(conclusion.status));
    }
    Error error{ErrorCode::TransferIncomplete,
        {node.name(),
            total > 0 ? QStringLiteral("%1 of %2").arg(missing).arg(total)
                      : QString::number(missing)}};
    if (intake.refusal())
        error.arguments.append(intake.refusal()->arguments.value(1));
    else if (conclusion.status != 0)
        error.arguments.append(statusText(conclusion.status));
    return tl::unexpected<Error>(error);
}

} // namespace

Result<Retrieved> retrieve(const PacsNode& node, const RetrieveWish& wish, const QString& target,
    const RetrieveWay& way, const Progress& progress)
{
    return retrieveInto(target, listingOf(node, progress, false), wish,
        [&](const RetrievePlan& plan, const DownloadFolder& folder) -> Result<int> {
            ObjectIntake intake(folder, plan.missing(), !plan.isKnown(), progress);
            const Result<Conclusion> conclusion = fetch(node, plan, intake, way, progress);
            if (!conclusion)
                return tl::unexpected<Error>(conclusion.error());
            // Of a series that is not listed only the node can tell whether all of it came.
            const bool toldBad =
                conclusion->status != 0 && (!plan.isKnown() || intake.received() == 0);
            if (!intake.missing().isEmpty() || conclusion->failed > 0 || intake.refusal()
                || toldBad) {
                return incomplete(
                    node, intake, *conclusion, plan.isKnown() ? plan.instances().size() : 0);
            }
            return intake.received();
        });
}

} // namespace core
