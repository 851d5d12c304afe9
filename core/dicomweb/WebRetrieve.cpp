// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebRetrieve.h"

#include "core/dicomweb/WebConnection.h"
#include "core/dicomweb/WebIntake.h"
#include "core/dicomweb/WebQuery.h"
#include "core/pacs/retrieve/DownloadFolder.h"
#include "core/pacs/retrieve/RetrievePlan.h"

#include <algorithm>
#include <optional>

namespace core {

namespace {

QByteArray pathOfSeries(const QString& studyUid, const QString& seriesUid)
{
    return "/studies/" + studyUid.toLatin1() + "/series/" + seriesUid.toLatin1();
}

/// One answer.
Result<void> fetch(WebConnection& connection, const QByteArray& path, WebIntake& intake)
{
    // As they are stored: nothing is converted on the way.
    const Result<WebAnswer> answer =
        connection.get(path, "multipart/related; type=\"application/dicom\"; transfer-syntax=*",
            Clause::saying("the download"), intake, false);
    if (!answer)
        return tl::unexpected<Error>(answer.error());
    return intake.end();
}

/// Whatever of a series is still missing.
/// @param unlisted grows by what the server counts, does not list, and did not send
Result<void> fetchSeries(WebConnection& connection, const QString& studyUid,
    const RetrievePlan::Series& series, WebIntake& intake, qsizetype& unlisted)
{
    const QByteArray path = pathOfSeries(studyUid, series.seriesUid);
    const auto isMissing = [&](const QString& uid) { return intake.missing().contains(uid); };
    if (!series.isListed()) {
        const int before = intake.accepted();
        if (Result<void> fetched = fetch(connection, path, intake); !fetched)
            return fetched;
        const qsizetype awaited =
            std::count_if(series.missing.begin(), series.missing.end(), isMissing);
        unlisted += std::max<qsizetype>(0, series.counted - (intake.accepted() - before) - awaited);
        return {};
    }
    const bool isWhole =
        series.asWhole() && std::all_of(series.missing.begin(), series.missing.end(), isMissing);
    if (isWhole)
        return fetch(connection, path, intake);
    for (const QString& uid : series.missing) {
        if (!isMissing(uid))
            continue;
        Result<void> fetched = fetch(connection, path + "/instances/" + uid.toLatin1(), intake);
        // It does not have every object that it lists: the others come nevertheless.
        if (!fetched && fetched.error().code != ErrorCode::NodeHasNone)
            return fetched;
    }
    return {};
}

Result<void> fetchAll(
    WebConnection& connection, const RetrievePlan& plan, WebIntake& intake, qsizetype& unlisted)
{
    unlisted = 0;
    std::optional<Error> none;
    bool lacksUnlisted = false;
    for (const RetrievePlan::Series& series : plan.series) {
        if (series.isHere())
            continue;
        const Result<void> fetched =
            fetchSeries(connection, plan.studyUid, series, intake, unlisted);
        if (fetched)
            continue;
        if (fetched.error().code != ErrorCode::NodeHasNone)
            return fetched;
        // The other series come nevertheless.
        if (!none)
            none = fetched.error();
        lacksUnlisted = lacksUnlisted || !series.isListed();
    }
    // What is missing of listed series the intake knows, and counts.
    if (none && (lacksUnlisted || intake.received() == 0))
        return tl::unexpected<Error>(*none);
    return {};
}

/// Takes a connection that ended up again, as long as that brings something.
Result<void> fetchPatiently(
    WebConnection& connection, const RetrievePlan& plan, WebIntake& intake, qsizetype& unlisted)
{
    const WebNode& node = connection.node();
    int retries = 0;
    int pauseMs = node.firstPauseMs;
    for (;;) {
        const int before = intake.received();
        Result<void> fetched = fetchAll(connection, plan, intake, unlisted);
        if (fetched || fetched.error().code != ErrorCode::NodeLost)
            return fetched;
        if (intake.received() > before) {
            retries = 0;
            pauseMs = node.firstPauseMs;
        }
        if (++retries > node.retries)
            return fetched;
        if (Result<void> waited = connection.pause(pauseMs); !waited)
            return waited;
        pauseMs *= 2;
    }
}

/// @param total of objects; 0: nobody could list or count them before
tl::unexpected<Error> incomplete(
    const WebNode& node, const WebIntake& intake, qsizetype unlisted, qsizetype total)
{
    const qsizetype missing = std::max<qsizetype>(1, intake.missing().size() + unlisted);
    Error error{ErrorCode::TransferIncomplete,
        {node.name(),
            total > 0 ? QStringLiteral("%1 of %2").arg(missing).arg(total)
                      : QString::number(missing)}};
    if (intake.refusal())
        error.arguments.append(intake.refusal()->arguments.value(1));
    return tl::unexpected<Error>(error);
}

} // namespace

Result<Retrieved> retrieve(
    const WebNode& node, const RetrieveWish& wish, const QString& target, const Progress& progress)
{
    return retrieveInto(target, listingOf(node, progress, true), wish,
        [&](const RetrievePlan& plan, const DownloadFolder& folder) -> Result<int> {
            Result<WebConnection> connection = WebConnection::open(node, progress);
            if (!connection)
                return tl::unexpected<Error>(connection.error());
            WebIntake intake(folder, plan.missing(), !plan.isKnown(), node.name(), progress);
            qsizetype unlisted = 0;
            const Result<void> fetched = fetchPatiently(*connection, plan, intake, unlisted);
            if (!fetched)
                return tl::unexpected<Error>(fetched.error());
            if (!intake.missing().isEmpty() || unlisted > 0 || intake.refusal()
                || intake.received() == 0)
                return incomplete(node, intake, unlisted, plan.total());
            return intake.received();
        });
}

} // namespace core
