// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebRetrieve.h"

#include "core/dicomweb/WebConnection.h"
#include "core/dicomweb/WebIntake.h"
#include "core/dicomweb/WebQuery.h"
#include "core/pacs/DownloadFolder.h"
#include "core/pacs/RetrievePlan.h"

#include <algorithm>

namespace core {

namespace {

QByteArray pathOf(const QString& studyUid, const QString& seriesUid)
{
    return "/studies/" + studyUid.toLatin1() + "/series/" + seriesUid.toLatin1();
}

/// One answer.
Result<void> fetch(WebConnection& connection, const QByteArray& path, WebIntake& intake)
{
    // As they are stored: nothing is converted on the way.
    const Result<WebAnswer> answer =
        connection.get(path, "multipart/related; type=\"application/dicom\"; transfer-syntax=*",
            QStringLiteral("the download"), intake, false);
    if (!answer)
        return tl::unexpected<Error>(answer.error());
    return intake.end();
}

/// Whatever of a series is still missing.
Result<void> fetchSeries(WebConnection& connection, const QString& studyUid,
    const RetrievePlan::Series& series, WebIntake& intake)
{
    const QByteArray path = pathOf(studyUid, series.seriesUid);
    const auto isMissing = [&](const QString& uid) { return intake.missing().contains(uid); };
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

Result<void> fetchAll(WebConnection& connection, const RetrievePlan& plan, WebIntake& intake)
{
    for (const RetrievePlan::Series& series : plan.series) {
        if (!series.instances.empty() && series.missing.isEmpty())
            continue;
        if (Result<void> fetched = fetchSeries(connection, plan.studyUid, series, intake); !fetched)
            return fetched;
    }
    return {};
}

/// Takes a connection that ended up again, as long as that brings something.
Result<void> fetchPatiently(WebConnection& connection, const RetrievePlan& plan, WebIntake& intake)
{
    const WebNode& node = connection.node();
    int retries = 0;
    int pauseMs = node.firstPauseMs;
    for (;;) {
        const int before = intake.received();
        Result<void> fetched = fetchAll(connection, plan, intake);
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

} // namespace

Result<Retrieved> retrieve(
    const WebNode& node, const RetrieveWish& wish, const QString& target, const Progress& progress)
{
    Result<RetrievePlan> plan = RetrievePlan::make(
        {.nodeName = node.name(),
            .series = [&](const QString& study) { return findSeries(node, study, progress); },
            .instances =
                [&](const QString& study, const QString& series) {
                    return findInstances(node, study, series, progress);
                }},
        wish);
    if (!plan)
        return tl::unexpected<Error>(plan.error());
    const QStringList instances = plan->instances();
    if (plan->isKnown() && DownloadFolder::isWhole(target, instances))
        return Retrieved{.received = 0, .kept = int(instances.size())};
    Result<DownloadFolder> folder = DownloadFolder::open(target);
    if (!folder)
        return tl::unexpected<Error>(folder.error());
    plan->lookWhatIsMissing(*folder);
    const QSet<QString> missing = plan->missing();
    Retrieved result{.received = 0, .kept = int(instances.size() - missing.size())};
    if (!plan->isKnown() || !missing.isEmpty()) {
        Result<WebConnection> connection = WebConnection::open(node, progress);
        if (!connection)
            return tl::unexpected<Error>(connection.error());
        WebIntake intake(
            *folder, plan->isKnown() ? missing : QSet<QString>(), node.name(), progress);
        const Result<void> fetched = fetchPatiently(*connection, *plan, intake);
        if (!fetched)
            return tl::unexpected<Error>(fetched.error());
        if (!intake.missing().isEmpty() || intake.refusal() || intake.received() == 0) {
            Error error{ErrorCode::TransferIncomplete,
                {node.name(),
                    QStringLiteral("%1 of %2")
                        .arg(std::max<qsizetype>(1, intake.missing().size()))
                        .arg(instances.size())}};
            if (intake.refusal())
                error.arguments.append(intake.refusal()->arguments.value(1));
            return tl::unexpected<Error>(error);
        }
        result.received = intake.received();
    }
    if (const Result<void> finished = folder->finish(); !finished)
        return tl::unexpected<Error>(finished.error());
    return result;
}

} // namespace core
