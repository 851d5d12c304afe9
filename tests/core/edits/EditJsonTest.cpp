// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/EditDocumentation.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/segments/SegmentSeen.h"
#include "core/edits/kinds/splitting/CopySegment.h"
#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/edits/kinds/views/Measurements.h"
#include "tests/support/program/TestProgram.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

#include <cmath>
#include <limits>

namespace editJsonTest {

using namespace core;

namespace {

/// @param text JSON with ' in place of "
QJsonObject parse(QByteArray text)
{
    return QJsonDocument::fromJson(text.replace('\'', '"')).object();
}

const QByteArray drillText =
    "{'edit':'drill',"
    "'view':{'eyeLps':[0,-400,10],'targetLps':[0,0,10],'up':[0,0,1],'heightMm':300,'orthographic':"
    "true},"
    "'mask':{'shape':'circle','radiusMm':8},'depthMm':6,'surface':{'threshold':250},"
    "'samples':[[0,0,0.5,0],[4,1,1,0.25]]}";

/// The object with one value replaced; @p path as in error messages, e.g. "view.up".
QJsonObject with(QJsonObject object, const QStringList& path, const QJsonValue& value)
{
    if (path.size() == 1) {
        if (value.isUndefined())
            object.remove(path[0]);
        else
            object.insert(path[0], value);
        return object;
    }
    object.insert(path[0], with(object.value(path[0]).toObject(), path.mid(1), value));
    return object;
}

} // namespace

class EditJsonTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void readsTheRecipesOfTheManual()
    {
        const Result<Edit> add = editFromJson(parse("{'edit':'addSegment','name':'Skull','color':'#"
                                                    "E0c068','code':['SCT','89546000','Skull']}"));
        QVERIFY(add);
        const auto& segment = add->get<AddSegment>();
        QCOMPARE(segment.name, QStringLiteral("Skull"));
        QCOMPARE(segment.rgb, 0xE0C068u);
        QCOMPARE(segment.code.value, QStringLiteral("89546000"));

        const Result<Edit> seed =
            editFromJson(parse("{'edit':'seed','segment':2,'pointsLps':[[1,2.5,-3],[4,5,6]]}"));
        QVERIFY(seed);
        QCOMPARE(seed->get<SeedStroke>().segment, 2);
        QCOMPARE(seed->get<SeedStroke>().pointsLps.at(0).y, 2.5);

        const Result<Edit> grow = editFromJson(parse(
            "{'edit':'grow','lower':-10.5,'upper':300,'connectivity':6,'steps':'toClosure'}"));
        QVERIFY(grow);
        QCOMPARE(grow->get<GrowSteps>().criteria.lower, -10.5);
        QVERIFY(!grow->get<GrowSteps>().steps);
        QVERIFY(!grow->get<GrowSteps>().criteria.overwriteUnlocked);

        const Result<Edit> drill = editFromJson(parse(drillText));
        QVERIFY(drill);
        const auto& stroke = drill->get<DrillStroke>();
        QCOMPARE(stroke.view.eyeLps.y, -400.0);
        QCOMPARE(stroke.mask.radiusMm, 8.0);
        QCOMPARE(stroke.surfaceThreshold, 250.0);
        QCOMPARE(stroke.layer, 1);
        QCOMPARE(stroke.pressureExponent, 2);
        QCOMPARE(stroke.samples.size(), std::size_t(2));
        QCOMPARE(stroke.samples[1].tSeconds, 0.25);

        const Result<Edit> change =
            editFromJson(parse("{'edit':'changeSegment','segment':1,'name':'Bone'}"));
        QVERIFY(change);
        QCOMPARE(*change->get<ChangeSegment>().name, QStringLiteral("Bone"));
        QVERIFY(!change->get<ChangeSegment>().rgb);
    }

    void readsWhatPassesBetweenLayersAndSegments()
    {
        const Result<Edit> carved = editFromJson(
            parse("{'edit':'layerToSegment','layer':1,'name':'Skull cap','color':'#e0c068'}"));
        QVERIFY(carved);
        QVERIFY(!carved->get<LayerToSegment>().target.segment);
        QCOMPARE(carved->get<LayerToSegment>().target.name, QStringLiteral("Skull cap"));
        const Result<Edit> seen =
            editFromJson(parse("{'edit':'segmentSeen','segment':2,'lower':300,"
                               "'hidden':[[0,0,1,3.0001]]}"));
        QVERIFY(seen);
        QCOMPARE(*seen->get<SegmentSeen>().target.segment, 2);
        QCOMPARE(quantised(*seen).get<SegmentSeen>().hidden->at(0).offsetMm, 3.0);
        const Result<Edit> inverted = editFromJson(parse("{'edit':'invertSegment','segment':2}"));
        QVERIFY(inverted);
        QCOMPARE(inverted->get<InvertSegment>().segment, 2);
        const Result<Edit> cleaned = editFromJson(
            parse("{'edit':'cleanSegment','segment':2,'rule':'removeSmall','mm3':40.0000002}"));
        QVERIFY(cleaned);
        QVERIFY(cleaned->get<CleanSegment>().rule == IslandRule::RemoveSmall);
        QCOMPARE(*quantised(*cleaned).get<CleanSegment>().mm3, 40.0);
        QVERIFY(!editFromJson(parse("{'edit':'cleanSegment','segment':2,'rule':'polish'}")));
        // An edit of before says the same as ever: what came later is not written.
        QCOMPARE(editToJson(*cleaned).size(), 4);
        const Result<Edit> given = editFromJson(
            parse("{'edit':'cleanSegment','segment':2,'rule':'giveClicked','islandLps':[1,-2.5,3],"
                  "'to':5}"));
        QVERIFY(given);
        QVERIFY(given->get<CleanSegment>().rule == IslandRule::GiveClicked);
        QVERIFY(given->get<CleanSegment>().islandLps == glm::dvec3(1.0, -2.5, 3.0));
        QVERIFY(given->get<CleanSegment>().to == 5);
        for (const char* rule : {"keepClicked", "removeClicked"})
            QVERIFY(editFromJson(
                parse(qPrintable(QStringLiteral("{'edit':'cleanSegment','segment':2,'rule':'%1',"
                                                "'islandLps':[0,0,0]}")
                                     .arg(QLatin1String(rule))))));
        const Result<Edit> merged =
            editFromJson(parse("{'edit':'combineSegments','segment':2,'with':1,'how':'merge'}"));
        const Result<Edit> swapped =
            editFromJson(parse("{'edit':'combineSegments','segment':3,'with':1,'how':'swap'}"));
        QVERIFY(merged && swapped);
        QVERIFY(merged->get<CombineSegments>().how == CombineSegments::How::Merge);
        QVERIFY(swapped->get<CombineSegments>().how == CombineSegments::How::Swap);
        QCOMPARE(swapped->get<CombineSegments>().segment, 3);
        QCOMPARE(swapped->get<CombineSegments>().with, 1);
        const Result<Edit> grown = editFromJson(
            parse("{'edit':'reshapeSegment','segment':2,'operation':'grow','mm':1.50001}"));
        const Result<Edit> shell =
            editFromJson(parse("{'edit':'reshapeSegment','segment':2,'operation':'hollow','mm':3,"
                               "'shell':'outside'}"));
        QVERIFY(grown && shell);
        QVERIFY(grown->get<ReshapeSegment>().operation == ShapeOperation::Grow);
        QVERIFY(!grown->get<ReshapeSegment>().shell);
        QCOMPARE(quantised(*grown).get<ReshapeSegment>().mm, 1.5);
        QVERIFY(shell->get<ReshapeSegment>().operation == ShapeOperation::Hollow);
        QVERIFY(shell->get<ReshapeSegment>().shell == ShellPlace::Outside);
        const Result<Edit> sided =
            editFromJson(parse("{'edit':'reshapeSegment','segment':2,'operation':'grow','mm':3,"
                               "'leftMm':0,'superiorMm':4.00001}"));
        QVERIFY(sided);
        const SideMargins sides = quantised(*sided).get<ReshapeSegment>().sides;
        QCOMPARE(sides.leftMm.value_or(-1.0), 0.0);
        QCOMPARE(sides.superiorMm.value_or(-1.0), 4.0);
        const Result<Edit> joint =
            editFromJson(parse("{'edit':'reshapeSegment','segment':2,'operation':'gaussian','mm':1,"
                               "'with':[1,5]}"));
        QVERIFY(joint);
        QCOMPARE(joint->get<ReshapeSegment>().with.value_or(std::vector<int>()),
            (std::vector<int>{1, 5}));
        QVERIFY(!sides.rightMm && !sides.anteriorMm && !sides.posteriorMm && !sides.inferiorMm);
        for (const char* operation : {"shrink", "open", "close", "median", "wrap", "gaussian"})
            QVERIFY(
                editFromJson(parse(qPrintable(QStringLiteral("{'edit':'reshapeSegment','segment':2,"
                                                             "'operation':'%1','mm':2}")
                                                  .arg(QLatin1String(operation))))));
        const Result<Edit> mirror =
            editFromJson(parse("{'edit':'mirrorSegment','segment':2,'sides':'inferiorSuperior',"
                               "'placeLps':[1,2,3.00001],'keep':true}"));
        QVERIFY(mirror);
        QVERIFY(mirror->get<MirrorSegment>().sides == MirroredSides::InferiorSuperior);
        QVERIFY(mirror->get<MirrorSegment>().keep);
        QVERIFY(quantised(*mirror).get<MirrorSegment>().placeLps == glm::dvec3(1.0, 2.0, 3.0));
        const Result<Edit> islands =
            editFromJson(parse("{'edit':'splitIslands','segment':2,'mm3':40.5,"
                               "'into':[{'name':'One','color':'#102030'},"
                               "{'name':'Two','color':'#405060'}]}"));
        const Result<Edit> every = editFromJson(parse("{'edit':'splitIslands','segment':2}"));
        const Result<Edit> split =
            editFromJson(parse("{'edit':'splitSegment','segment':2,'placeLps':[1,2,3.00001],"
                               "'normalLps':[0,0,-2],'name':'Lower','color':'#102030'}"));
        QVERIFY(islands && every && split);
        QVERIFY(islands->get<SplitIslands>().mm3 == 40.5);
        QVERIFY(islands->get<SplitIslands>().into
            == (std::vector<SplitPart>{
                {QStringLiteral("One"), 0x102030}, {QStringLiteral("Two"), 0x405060}}));
        QVERIFY(!every->get<SplitIslands>().mm3 && !every->get<SplitIslands>().into);
        QVERIFY(quantised(*split).get<SplitSegment>().placeLps == glm::dvec3(1.0, 2.0, 3.0));
        QVERIFY(split->get<SplitSegment>().normalLps == glm::dvec3(0.0, 0.0, -2.0));
        QCOMPARE(split->get<SplitSegment>().into.name, QStringLiteral("Lower"));
        const Result<Edit> copy = editFromJson(
            parse("{'edit':'copySegment','segment':2,'name':'Again','color':'#102030'}"));
        const Result<Edit> beside = editFromJson(
            parse("{'edit':'copySegment','segment':2,'name':'Again','color':'#102030','plane':3}"));
        QVERIFY(copy && beside);
        QVERIFY(!copy->get<CopySegment>().plane && beside->get<CopySegment>().plane == 3);
        QCOMPARE(beside->get<CopySegment>().segment, 2);
        const QByteArray view = "'view':{'eyeLps':[0,-400,100],'targetLps':[0,0,100],"
                                "'up':[0,0,1],'heightMm':250},'name':'Lower','color':'#102030'";
        const Result<Edit> curve = editFromJson(parse(
            "{'edit':'splitByCurve','segment':2,'curveMm':[[0,0],[9,0],[0,9.0001]],'depthMm':4,"
            + view + '}'));
        const Result<Edit> line = editFromJson(parse("{'edit':'splitByCurve','segment':2,"
                                                     "'open':true,'curveMm':[[0,0],[9,3]],"
                                                     "'side':'smaller',"
            + view + '}'));
        QVERIFY(curve && line);
        QVERIFY(!curve->get<SplitByCurve>().open && curve->get<SplitByCurve>().depthMm == 4.0);
        QVERIFY(curve->get<SplitByCurve>().side == SplitByCurve::Side::Inside);
        QVERIFY(quantised(*curve).get<SplitByCurve>().curveMm[2] == glm::dvec2(0.0, 9.0));
        QVERIFY(line->get<SplitByCurve>().open && line->get<SplitByCurve>().curveMm.size() == 2);
        QVERIFY(line->get<SplitByCurve>().side == SplitByCurve::Side::Smaller);
        QCOMPARE(line->get<SplitByCurve>().into.name, QStringLiteral("Lower"));
        // A curve that closes needs more points, and a depth means the inside.
        QVERIFY(!editFromJson(
            parse("{'edit':'splitByCurve','segment':2,'curveMm':[[0,0],[9,0]]," + view + '}')));
        QVERIFY(!editFromJson(parse("{'edit':'splitByCurve','segment':2,'side':'outside',"
                                    "'depthMm':4,'curveMm':[[0,0],[9,0],[0,9]],"
            + view + '}')));
        const Result<Edit> between =
            editFromJson(parse("{'edit':'fillBetweenSlices','segment':2}"));
        const Result<Edit> across =
            editFromJson(parse("{'edit':'fillBetweenSlices','segment':2,'axis':'j'}"));
        QVERIFY(between && across);
        QVERIFY(!between->get<FillBetweenSlices>().axis);
        QVERIFY(across->get<FillBetweenSlices>().axis == SliceAxis::J);
        const QByteArray planes("'planes':[{'placeLps':[1,2,3.0001],'normalLps':[0,0,1]},"
                                "{'placeLps':[4,5,6],'normalLps':[1,1,0]}]");
        const Result<Edit> several =
            editFromJson(parse("{'edit':'fillBetweenSlices','segment':2," + planes + '}'));
        QVERIFY(several && several->get<FillBetweenSlices>().planes->size() == 2);
        QVERIFY(quantised(*several).get<FillBetweenSlices>().planes->front()
            == (DrawnPlane{{1.0, 2.0, 3.0}, {0.0, 0.0, 1.0}}));
        QVERIFY(editToJson(*editFromJson(editToJson(*several))) == editToJson(*several));
        QVERIFY(!editFromJson(
            parse("{'edit':'fillBetweenSlices','segment':2,'axis':'j'," + planes + '}')));
        const Result<Edit> contour = editFromJson(parse("{'edit':'evolveContour','segment':2}"));
        const Result<Edit> bubble = editFromJson(
            parse("{'edit':'evolveContour','segment':2,'lower':1,'edge':50,'edgeGradient':30,"
                  "'bubbleLps':[1,2,3],'bubbleMm':4,'generations':7}"));
        QVERIFY(contour && bubble);
        QVERIFY(contour->get<EvolveContour>() == EvolveContour{.segment = 2});
        QVERIFY(bubble->get<EvolveContour>().bubbleLps == glm::dvec3(1.0, 2.0, 3.0));
        QCOMPARE(bubble->get<EvolveContour>().generations, 7);
        QVERIFY(!editToJson(*contour).contains(QLatin1String("round")));
        QVERIFY(!editToJson(*bubble).contains(QLatin1String("furtherBubblesLps")));
        const Result<Edit> bubbles =
            editFromJson(parse("{'edit':'evolveContour','segment':2,'bubbleLps':[1,2,3],"
                               "'bubbleMm':4,'furtherBubblesLps':[[4,5,6.0001],[7,8,9]]}"));
        QVERIFY(bubbles);
        QVERIFY(quantised(*bubbles).get<EvolveContour>().furtherBubblesLps
            == (std::vector<glm::dvec3>{{4.0, 5.0, 6.0}, {7.0, 8.0, 9.0}}));
        QVERIFY(editToJson(*editFromJson(editToJson(*bubbles))) == editToJson(*bubbles));
        const Result<Edit> round =
            editFromJson(parse("{'edit':'evolveContour','segment':2,'round':true}"));
        QVERIFY(round);
        QVERIFY(round->get<EvolveContour>() == (EvolveContour{.segment = 2, .round = true}));
        QVERIFY(editToJson(*round)[QLatin1String("round")].toBool());
        QVERIFY(!editToJson(*round).contains(QLatin1String("erase")));
        const Result<Edit> erasing =
            editFromJson(parse("{'edit':'evolveContour','segment':2,'erase':true}"));
        QVERIFY(erasing);
        QVERIFY(erasing->get<EvolveContour>() == (EvolveContour{.segment = 2, .erase = true}));
        QVERIFY(!editToJson(*erasing).contains(QLatin1String("overwriteUnlocked")));
        QVERIFY(bubble->get<EvolveContour>().lower == 1.0 && !bubble->get<EvolveContour>().upper);
        const Result<Edit> flood = editFromJson(parse("{'edit':'floodFill','segment':2,"
                                                      "'placeLps':[1,2,3],'tolerance':40}"));
        const Result<Edit> away =
            editFromJson(parse("{'edit':'floodFill','segment':2,'placeLps':[1,2,3],'within':'k',"
                               "'corners':true,'erase':true}"));
        QVERIFY(flood && away);
        QVERIFY(!flood->get<FloodFill>().within && !flood->get<FloodFill>().corners);
        QCOMPARE(flood->get<FloodFill>().tolerance, 40.0);
        QVERIFY(away->get<FloodFill>().within == SliceAxis::K);
        QVERIFY(away->get<FloodFill>().corners && away->get<FloodFill>().erase);
        QVERIFY(!editToJson(*flood).contains(QLatin1String("normalLps")));
        const Result<Edit> oblique =
            editFromJson(parse("{'edit':'floodFill','segment':2,'placeLps':[1,2,3],"
                               "'normalLps':[0,0.50000001,1],'tolerance':40}"));
        QVERIFY(oblique);
        QVERIFY(quantised(*oblique).get<FloodFill>().normalLps == glm::dvec3(0.0, 0.5, 1.0));
        QVERIFY(!editFromJson(parse("{'edit':'floodFill','segment':2,'placeLps':[1,2,3],"
                                    "'within':'k','normalLps':[0,0,1],'tolerance':40}")));
        const Result<Edit> threshold =
            editFromJson(parse("{'edit':'thresholdSegment','segment':3,'lower':300.5,"
                               "'mode':'subtract','box':[[1,2,3],[4.00001,5,6]],"
                               "'onlyVisible':true,'overwriteUnlocked':true}"));
        const Result<Edit> everything =
            editFromJson(parse("{'edit':'thresholdSegment','segment':3}"));
        QVERIFY(threshold && everything);
        const auto& limited = threshold->get<ThresholdSegment>();
        QVERIFY(limited.lower == 300.5 && !limited.upper && limited.segment == 3);
        QVERIFY(limited.mode == ThresholdSegment::Mode::Subtract);
        QVERIFY(limited.onlyVisible && limited.overwriteUnlocked);
        QCOMPARE(
            quantised(*threshold).get<ThresholdSegment>().box->toLps, (glm::dvec3{4.0, 5.0, 6.0}));
        const auto& whole = everything->get<ThresholdSegment>();
        QVERIFY(!whole.lower && !whole.upper && !whole.box && !whole.onlyVisible);
        QVERIFY(whole.mode == ThresholdSegment::Mode::Replace && !whole.overwriteUnlocked);
        QVERIFY(editFromJson(parse("{'edit':'thresholdSegment','segment':3,'mode':'add'}")));
        const Result<Edit> angle =
            editFromJson(parse("{'edit':'annotate','kind':'angle',"
                               "'pointsLps':[[1,2,3],[4,5,6],[7.00001,8,10]],'projected':true}"));
        const Result<Edit> note = editFromJson(parse(
            "{'edit':'annotate','kind':'text','pointsLps':[[1,2,3]],'text':'Here','piece':2}"));
        const Result<Edit> onSlab = editFromJson(
            parse("{'edit':'addMeasurement','fromLps':[1,2,3],'toLps':[4,5,6],'projected':true}"));
        const Result<Edit> distance =
            editFromJson(parse("{'edit':'addMeasurement','fromLps':[1,2,3],'toLps':[4,5,6]}"));
        QVERIFY(angle && note && onSlab && distance);
        QVERIFY(angle->get<Annotate>().kind == Measurement::Kind::Angle);
        QVERIFY(angle->get<Annotate>().projected == true && !angle->get<Annotate>().text);
        QCOMPARE(quantised(*angle).get<Annotate>().pointsLps[2], (glm::dvec3{7.0, 8.0, 10.0}));
        QVERIFY(note->get<Annotate>().text == QStringLiteral("Here"));
        QVERIFY(note->get<Annotate>().piece == 2 && !note->get<Annotate>().projected);
        QVERIFY(onSlab->get<AddMeasurement>().projected == true);
        // An old row stays as it was written.
        QVERIFY(!editToJson(*distance).contains(QStringLiteral("projected")));
        for (const Edit& edit :
            {*angle, *note, *onSlab, *distance, *carved, *seen, *inverted, *cleaned, *given,
                *merged, *swapped, *grown, *shell, *between, *across, *flood, *contour, *bubble,
                *bubbles, *away, *threshold, *everything, *islands, *every, *split, *copy, *beside})
            QCOMPARE(editToJson(*editFromJson(editToJson(edit))), editToJson(edit));
        for (const char* wrong :
            {"{'edit':'layerToSegment','layer':1}",
                "{'edit':'layerToSegment','layer':1,'segment':2,'name':'Both'}",
                "{'edit':'segmentSeen','segment':2,'hidden':[[0,0,1]]}",
                "{'edit':'segmentSeen','segment':2,'hidden':[[0,0,0,1]]}",
                "{'edit':'segmentSeen','segment':2,'hidden':{}}", "{'edit':'mergeLayers','from':1}",
                "{'edit':'cleanSegment','segment':2,'rule':'keepClicked','islandLps':[1,2]}",
                "{'edit':'cleanSegment','segment':2,'rule':'keepClicked','islandLps':'here'}",
                "{'edit':'cleanSegment','segment':2,'rule':'giveClicked','islandLps':[1,2,3],'to':"
                "0}",
                "{'edit':'combineSegments','segment':2,'with':1}",
                "{'edit':'combineSegments','segment':2,'how':'merge'}",
                "{'edit':'combineSegments','segment':2,'with':0,'how':'merge'}",
                "{'edit':'combineSegments','segment':2,'with':1,'how':'difference'}",
                "{'edit':'splitIslands'}", "{'edit':'splitIslands','segment':2,'mm3':-1}",
                "{'edit':'splitIslands','segment':2,'into':[]}",
                "{'edit':'splitIslands','segment':2,'into':['One']}",
                "{'edit':'splitIslands','segment':2,'into':[{'name':'One'}]}",
                "{'edit':'splitIslands','segment':2,'into':[{'name':'One','color':'#102030',"
                "'code':[]}]}",
                "{'edit':'splitSegment','segment':2,'normalLps':[0,0,1],'name':'A','color':'#1'}",
                "{'edit':'splitSegment','segment':2,'placeLps':[1,2,3],'normalLps':[0,0,1]}",
                "{'edit':'mirrorSegment','segment':2}",
                "{'edit':'mirrorSegment','segment':2,'sides':'upDown'}",
                "{'edit':'reshapeSegment','segment':2,'operation':'grow'}",
                "{'edit':'reshapeSegment','segment':2,'mm':1}",
                "{'edit':'reshapeSegment','segment':2,'operation':'grow','mm':0}",
                "{'edit':'reshapeSegment','segment':2,'operation':'grow','mm':100.5}",
                "{'edit':'reshapeSegment','segment':2,'operation':'polish','mm':1}",
                "{'edit':'reshapeSegment','segment':2,'operation':'grow','mm':1,'leftMm':-1}",
                "{'edit':'reshapeSegment','segment':2,'operation':'gaussian','mm':1,'with':[5,1]}",
                "{'edit':'reshapeSegment','segment':2,'operation':'gaussian','mm':1,'with':[]}",
                "{'edit':'reshapeSegment','segment':2,'operation':'hollow','mm':1,'shell':'on'}",
                "{'edit':'floodFill','segment':2,'placeLps':[1,2,3]}",
                "{'edit':'floodFill','segment':2,'tolerance':1}",
                "{'edit':'floodFill','segment':2,'placeLps':[1,2,3],'tolerance':-1}",
                "{'edit':'floodFill','segment':2,'placeLps':[1,2,3],'erase':true,'tolerance':1}",
                "{'edit':'floodFill','segment':2,'placeLps':[1,2,3],'tolerance':1,'within':'x'}",
                "{'edit':'evolveContour','segment':2,'smoothness':101}",
                "{'edit':'evolveContour','segment':2,'edge':10}",
                "{'edit':'evolveContour','segment':2,'edgeGradient':10}",
                "{'edit':'evolveContour','segment':2,'bubbleMm':10}",
                "{'edit':'evolveContour','segment':2,'bubbleLps':[1,2,3]}",
                "{'edit':'evolveContour','segment':2,'furtherBubblesLps':[[1,2,3]]}",
                "{'edit':'evolveContour','segment':2,'bubbleLps':[1,2,3],'bubbleMm':4,"
                "'furtherBubblesLps':[]}",
                "{'edit':'evolveContour','segment':2,'generations':0}",
                "{'edit':'evolveContour','segment':2,'erase':true,'overwriteUnlocked':true}",
                "{'edit':'fillBetweenSlices'}",
                "{'edit':'fillBetweenSlices','segment':2,'axis':'axial'}",
                "{'edit':'fillBetweenSlices','segment':2,'planes':[]}",
                "{'edit':'fillBetweenSlices','segment':2,'planes':[{'placeLps':[1,2,3]}]}",
                "{'edit':'fillBetweenSlices','segment':2,'axis':1}", "{'edit':'thresholdSegment'}",
                "{'edit':'thresholdSegment','segment':0}",
                "{'edit':'thresholdSegment','segment':2,'mode':'invert'}",
                "{'edit':'thresholdSegment','segment':2,'box':[[1,2,3]]}",
                "{'edit':'thresholdSegment','segment':2,'lower':'much'}",
                "{'edit':'annotate','kind':'angle'}",
                "{'edit':'annotate','kind':'cone','pointsLps':[[1,2,3]]}",
                "{'edit':'annotate','kind':'text','pointsLps':[[1,2,3]],'text':''}",
                "{'edit':'annotate','pointsLps':[[1,2,3]]}",
                "{'edit':'annotate','kind':'probe',"
                "'pointsLps':[]}",
                "{'edit':'invertSegment'}", "{'edit':'invertSegment','segment':0}"})
            QVERIFY2(!editFromJson(parse(wrong)), wrong);
    }

    void readsGrowingFromSeeds()
    {
        const Result<Edit> plain = editFromJson(parse("{'edit':'growFromSeeds'}"));
        QVERIFY(plain);
        const auto& all = plain->get<GrowFromSeeds>();
        QVERIFY(!all.segments && !all.box && !all.lengthCost && !all.overwriteUnlocked);
        QCOMPARE(all.connectivity, 6);
        const Result<Edit> full = editFromJson(
            parse("{'edit':'growFromSeeds','segments':[1,3],'box':[[0,-1,2],[10.00001,20,30]],"
                  "'connectivity':26,'lengthCost':0.5,'overwriteUnlocked':true}"));
        QVERIFY(full);
        const auto& some = full->get<GrowFromSeeds>();
        QCOMPARE(*some.segments, (std::vector<int>{1, 3}));
        QCOMPARE(*some.lengthCost, 0.5);
        QVERIFY(some.overwriteUnlocked);
        for (const Edit& edit : {*plain, quantised(*full)})
            QCOMPARE(editToJson(*editFromJson(editToJson(edit))), editToJson(edit));
        for (const char* wrong :
            {"{'edit':'growFromSeeds','segments':[]}", "{'edit':'growFromSeeds','segments':[3,1]}",
                "{'edit':'growFromSeeds','box':[[0,0,0]]}",
                "{'edit':'growFromSeeds','connectivity':7}",
                "{'edit':'growFromSeeds','lengthCost':-1}",
                "{'edit':'growFromSeeds','seeds':true}"})
            QVERIFY2(!editFromJson(parse(wrong)), wrong);
    }

    void readsChunks()
    {
        const Result<Edit> plain = editFromJson(parse("{'edit':'chunks','segment':2}"));
        QVERIFY(plain);
        QCOMPARE(plain->get<DivideSegment>().marginMm, 10.0);
        QVERIFY(!plain->get<DivideSegment>().owners);
        const Result<Edit> named =
            editFromJson(parse("{'edit':'chunks','segment':2,'marginMm':3.0001,"
                               "'owners':[{'label':1,'voxels':'AAEC'},{'label':2,'voxels':''}]}"));
        QVERIFY(named);
        QCOMPARE(quantised(*named).get<DivideSegment>().marginMm, 3.0);
        QCOMPARE(named->get<DivideSegment>().owners->front().voxels, QByteArray("\0\1\2", 3));
        const Result<Edit> clicked =
            editFromJson(parse("{'edit':'chunkToggle','segment':2,'chunks':40,"
                               "'pointsLps':[[1,2,3],[4,5,6]]}"));
        QVERIFY(clicked);
        QVERIFY(clicked->get<ChunkToggle>().mode == ChunkToggle::Mode::Toggle);
        QVERIFY(!clicked->get<ChunkToggle>().bricks);
        const Result<Edit> forced = editFromJson(
            parse("{'edit':'chunkToggle','segment':2,'chunks':40,'mode':'remove',"
                  "'pointsLps':[[1,2,3]],'overwriteUnlocked':true,'bricks':[0,7,90000]}"));
        QVERIFY(forced);
        QVERIFY(forced->get<ChunkToggle>().mode == ChunkToggle::Mode::Remove);
        QCOMPARE(*forced->get<ChunkToggle>().bricks, (std::vector<std::int64_t>{0, 7, 90000}));
        for (const Edit& edit : {*plain, quantised(*named), *clicked, *forced})
            QCOMPARE(editToJson(*editFromJson(editToJson(edit))), editToJson(edit));
        for (const char* wrong : {"{'edit':'chunks'}", "{'edit':'chunks','segment':0}",
                 "{'edit':'chunks','segment':2,'marginMm':-1}",
                 "{'edit':'chunks','segment':2,'owners':[]}",
                 "{'edit':'chunks','segment':2,'owners':[{'label':1}]}",
                 "{'edit':'chunks','segment':2,'owners':[{'label':256,'voxels':''}]}",
                 "{'edit':'chunks','segment':2,'owners':[{'label':1,'voxels':'?'}]}",
                 "{'edit':'chunks','segment':2,"
                 "'owners':[{'label':2,'voxels':''},{'label':1,'voxels':''}]}",
                 "{'edit':'chunkToggle','segment':2,'chunks':40,'pointsLps':[]}",
                 "{'edit':'chunkToggle','segment':2,'chunks':0,'pointsLps':[[1,2,3]]}",
                 "{'edit':'chunkToggle','segment':2,'chunks':5001,'pointsLps':[[1,2,3]]}",
                 "{'edit':'chunkToggle','segment':2,'pointsLps':[[1,2,3]]}",
                 "{'edit':'chunkToggle','segment':2,'chunks':4,'mode':'take',"
                 "'pointsLps':[[1,2,3]]}",
                 "{'edit':'chunkToggle','segment':2,'chunks':4,'pointsLps':[[1,2,3]],"
                 "'bricks':[3,3]}",
                 "{'edit':'chunkToggle','segment':2,'chunks':4,'pointsLps':[[1,2,3]],"
                 "'bricks':[-1]}"})
            QVERIFY2(!editFromJson(parse(wrong)), wrong);
    }

    void readsOutlines()
    {
        const Result<Edit> plain = editFromJson(
            parse("{'edit':'fillOutline','segment':2,'originLps':[1,2.5,-3],'rightLps':[0,1,0],"
                  "'upLps':[0,0,-2],'polygonMm':[[0,0],[4,0.5],[-1,3]]}"));
        QVERIFY(plain);
        const auto& outline = plain->get<FillOutline>();
        QCOMPARE(outline.segment, 2);
        QVERIFY(outline.originLps == glm::dvec3(1.0, 2.5, -3.0));
        QVERIFY(outline.rightLps == glm::dvec3(0.0, 1.0, 0.0));
        QVERIFY(outline.upLps == glm::dvec3(0.0, 0.0, -2.0));
        QVERIFY(outline.polygonMm.at(1) == glm::dvec2(4.0, 0.5));
        QVERIFY(!outline.erase && !outline.overwriteUnlocked && !outline.lower && !outline.upper);
        const Result<Edit> full = editFromJson(
            parse("{'edit':'fillOutline','segment':1,'originLps':[0,0,0.0001],'rightLps':[1,0,0],"
                  "'upLps':[0,1,0],'polygonMm':[[0,0],[4,0],[0,3.0001]],'erase':true,'lower':-5,"
                  "'upper':7,'overwriteUnlocked':true}"));
        QVERIFY(full);
        const Edit rounded = quantised(*full);
        QCOMPARE(rounded.get<FillOutline>().originLps.z, 0.0);
        QCOMPARE(rounded.get<FillOutline>().polygonMm.at(2).y, 3.0);
        QVERIFY(rounded.get<FillOutline>().erase && rounded.get<FillOutline>().overwriteUnlocked);
        for (const Edit& edit : {*plain, rounded})
            QCOMPARE(editToJson(*editFromJson(editToJson(edit))), editToJson(edit));
        const QString known = QStringLiteral("'edit':'fillOutline','segment':2,'originLps':[0,0,0],"
                                             "'rightLps':[1,0,0]");
        for (const char* wrong :
            {"'upLps':[0,1,0],'polygonMm':[[0,0],[4,0]]",
                "'upLps':[0,1,0],'polygonMm':[[0,0],[4,0],[1]]",
                "'upLps':[0,1,0],'polygonMm':[[0,0],[4,0],[1,2001]]", "'upLps':[0,1,0]",
                "'upLps':[0,1],'polygonMm':[[0,0],[4,0],[1,2]]", "'polygonMm':[[0,0],[4,0],[1,2]]"})
            QVERIFY2(!editFromJson(parse(
                         qPrintable(QStringLiteral("{%1,%2}").arg(known, QLatin1String(wrong))))),
                wrong);
    }

    void readsSegmentScissors()
    {
        const QString known = QStringLiteral(
            "'edit':'segmentScissors','segment':2,'view':{'eyeLps':[0,-300,0],'targetLps':[0,0,0],"
            "'up':[0,0,1],'heightMm':200},'polygonMm':[[0,0],[4,0.0001],[-1,3]]");
        const auto read = [&known](const char* rest) {
            return editFromJson(
                parse(qPrintable(QStringLiteral("{%1%2}").arg(known, QLatin1String(rest)))));
        };
        const Result<Edit> plain = read("");
        QVERIFY(plain);
        const auto& filling = plain->get<SegmentScissors>();
        QCOMPARE(filling.segment, 2);
        QVERIFY(filling.view.eyeLps == glm::dvec3(0.0, -300.0, 0.0));
        QVERIFY(!filling.erase && !filling.outside && !filling.depthMm && !filling.others);
        QVERIFY(!filling.lower && !filling.upper && !filling.overwriteUnlocked && !filling.hidden);
        QCOMPARE(quantised(*plain).get<SegmentScissors>().polygonMm.at(1).y, 0.0);
        const Result<Edit> deep =
            read(",'erase':true,'depthMm':12.5,'others':[1,5],'lower':-5,'upper':7");
        QVERIFY(deep);
        const auto& erasing = deep->get<SegmentScissors>();
        QVERIFY(erasing.erase && erasing.depthMm == 12.5);
        QVERIFY(erasing.others == (std::vector<int>{1, 5}));
        QVERIFY(erasing.lower == -5.0 && erasing.upper == 7.0);
        const Result<Edit> beside = read(",'outside':true,'overwriteUnlocked':true,"
                                         "'hidden':[[0,0,1,5]]");
        QVERIFY(beside);
        QVERIFY(beside->get<SegmentScissors>().outside);
        QVERIFY(beside->get<SegmentScissors>().overwriteUnlocked);
        QCOMPARE(beside->get<SegmentScissors>().hidden->size(), std::size_t(1));
        for (const Edit& edit : {*plain, *deep, *beside})
            QCOMPARE(editToJson(*editFromJson(editToJson(edit))), editToJson(edit));
        for (const char* wrong :
            {",'outside':true,'depthMm':3", ",'others':[1]", ",'erase':true,'others':[5,1]",
                ",'erase':true,'overwriteUnlocked':true", ",'depthMm':-1", ",'layer':1"})
            QVERIFY2(!read(wrong), wrong);
    }

    void readsBrushes()
    {
        const Result<Edit> paint = editFromJson(
            parse("{'edit':'paint','segment':2,'radiusMm':6,'shape':'disc','normalLps':[0,0,1],"
                  "'pointsLps':[[1,2.5,-3],[4,5,6]],'lower':-10,'overwriteUnlocked':true}"));
        QVERIFY(paint);
        const auto& stroke = paint->get<PaintStroke>();
        QCOMPARE(stroke.segment, 2);
        QVERIFY(stroke.path.shape == BrushPath::Shape::Disc);
        QCOMPARE(stroke.path.normalLps->z, 1.0);
        QCOMPARE(stroke.path.pointsLps.at(1).z, 6.0);
        QCOMPARE(*stroke.lower, -10.0);
        QVERIFY(!stroke.upper && !stroke.erase && !stroke.seeds && stroke.overwriteUnlocked);
        QCOMPARE(editToJson(*editFromJson(editToJson(*paint))), editToJson(*paint));
        QVERIFY(!editToJson(*paint).contains(QLatin1String("sideLps")));
        QVERIFY(!editToJson(*paint).contains(QLatin1String("edgeTolerance")));
        QVERIFY(!stroke.edgeTolerance);
        const Result<Edit> edgewise = editFromJson(parse(
            "{'edit':'paint','segment':2,'radiusMm':6,'pointsLps':[[0,0,0]],'edgeTolerance':40}"));
        QVERIFY(edgewise);
        QCOMPARE(*edgewise->get<PaintStroke>().edgeTolerance, 40.0);
        QVERIFY(!editToJson(*edgewise).contains(QLatin1String("toleranceByPressure")));
        const Result<Edit> byPen =
            editFromJson(parse("{'edit':'paint','segment':2,'radiusMm':6,'pointsLps':[[0,0,0]],"
                               "'pressures':[0.5],'edgeTolerance':40,'toleranceByPressure':true}"));
        QVERIFY(byPen);
        QVERIFY(byPen->get<PaintStroke>().toleranceByPressure.value_or(false));
        QCOMPARE(editToJson(*editFromJson(editToJson(*byPen))), editToJson(*byPen));
        QCOMPARE(editToJson(*editFromJson(editToJson(*edgewise))), editToJson(*edgewise));
        QVERIFY(!editFromJson(parse("{'edit':'paint','segment':2,'radiusMm':6,"
                                    "'pointsLps':[[0,0,0]],'edgeTolerance':-1}")));
        QVERIFY(!stroke.tool);
        QVERIFY(!editToJson(*paint).contains(QLatin1String("tool")));
        const Result<Edit> nudge =
            editFromJson(parse("{'edit':'paint','segment':2,'radiusMm':6,'shape':'disc',"
                               "'normalLps':[0,0,1],'pointsLps':[[0,0,0]],'tool':'nudge'}"));
        QVERIFY(nudge);
        QVERIFY(nudge->get<PaintStroke>().tool == PaintStroke::Tool::Nudge);
        QCOMPARE(editToJson(*editFromJson(editToJson(*nudge))), editToJson(*nudge));
        const Result<Edit> unknown = editFromJson(
            parse("{'edit':'paint','segment':2,'radiusMm':6,'pointsLps':[[0,0,0]],'tool':'push'}"));
        QVERIFY(!unknown);
        QCOMPARE(unknown.error().arguments.value(0), QStringLiteral("paint.tool"));

        const Result<Edit> square = editFromJson(
            parse("{'edit':'paint','segment':2,'radiusMm':6,'shape':'square','normalLps':[0,0,1],"
                  "'sideLps':[1,0.5,0],'pointsLps':[[1,2.5,-3]]}"));
        QVERIFY(square);
        QVERIFY(square->get<PaintStroke>().path.shape == BrushPath::Shape::Square);
        QCOMPARE(square->get<PaintStroke>().path.sideLps->y, 0.5);
        QCOMPARE(editToJson(*editFromJson(editToJson(*square))), editToJson(*square));

        const Result<Edit> brush = editFromJson(
            parse("{'edit':'brush','radiusMm':4,'pointsLps':[[0,0,0]],'restore':true}"));
        QVERIFY(brush);
        QVERIFY(brush->get<BrushStroke>().restore);
        QVERIFY(brush->get<BrushStroke>().path.shape == BrushPath::Shape::Ball);
        QCOMPARE(brush->get<BrushStroke>().layer, 1);

        const Result<Edit> cone = editFromJson(
            parse("{'edit':'brush','radiusMm':4,'pointsLps':[[0,0,0]],'shape':'cone'}"));
        QVERIFY(!cone);
        QCOMPARE(cone.error().arguments.value(0), QStringLiteral("brush.shape"));
        const Result<Edit> lifted = editFromJson(
            parse("{'edit':'brush','radiusMm':4,'pointsLps':[[0,0,0],[9,0,0]],'lifts':[1]}"));
        QVERIFY(lifted);
        QCOMPARE(lifted->get<BrushStroke>().path.lifts, std::vector<std::int64_t>{1});
        QVERIFY(!editFromJson(
            parse("{'edit':'brush','radiusMm':4,'pointsLps':[[0,0,0]],'lifts':[2,2]}")));
        QVERIFY(!editToJson(*lifted).contains(QLatin1String("pressures")));
        const auto pressed = editFromJson(parse(
            "{'edit':'brush','radiusMm':4,'pointsLps':[[0,0,0],[9,0,0]],'pressures':[0.5,1]}"));
        QVERIFY(pressed);
        QCOMPARE(*pressed->get<BrushStroke>().path.pressures, (std::vector<double>{0.5, 1.0}));
        QVERIFY(editToJson(*pressed).contains(QLatin1String("pressures")));
        QVERIFY(!editFromJson(
            parse("{'edit':'brush','radiusMm':4,'pointsLps':[[0,0,0]],'pressures':[1.5]}")));
        QVERIFY(!editFromJson(parse("{'edit':'brush','radiusMm':4,'pointsLps':[]}")));
        QVERIFY(!editFromJson(parse("{'edit':'brush','radiusMm':0,'pointsLps':[[0,0,0]]}")));
    }

    void refusesUnknownEditsByName()
    {
        const Result<Edit> edit = editFromJson(parse("{'edit':'growl'}"));
        QVERIFY(!edit);
        QCOMPARE(edit.error().code, ErrorCode::UnknownEdit);
        QCOMPARE(edit.error().arguments.value(0), QStringLiteral("growl"));
    }

    void namesTheFieldThatIsWrong_data()
    {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QJsonValue>("value");
        const auto row = [](const char* name, const char* field, const QJsonValue& value) {
            QTest::newRow(name) << QString(QLatin1String(field)) << value;
        };
        const QJsonValue missing(QJsonValue::Undefined);
        row("missing number", "depthMm", missing);
        row("missing group", "mask", missing);
        row("missing in group", "view.up", missing);
        row("text for number", "depthMm", QStringLiteral("6"));
        row("null for number", "depthMm", QJsonValue());
        row("number for flag", "throughGaps", 1);
        row("list for group", "view", QJsonArray());
        row("unknown field", "depth", 6);
        row("unknown field in a group", "mask.diameterMm", 6);
        row("negative radius", "mask.radiusMm", -1.0);
        row("radius of zero", "mask.radiusMm", 0.0);
        row("huge position", "view.eyeLps", QJsonArray{0, 1e9, 0});
        row("short point", "view.eyeLps", QJsonArray{0, 0});
        row("text in point", "view.eyeLps", QJsonArray{0, 0, QStringLiteral("0")});
        row("another shape", "mask.shape", QStringLiteral("star"));
        row("perspective", "view.orthographic", false);
        row("fraction for whole number", "pressureExponent", 1.5);
        row("whole number out of range", "pressureExponent", 9);
        row("layer zero", "layer", 0);
        row("no samples", "samples", QJsonArray());
        row("pressure above one", "samples", QJsonArray{QJsonValue(QJsonArray{0, 0, 1.01, 0})});
        row("three numbers in a sample", "samples", QJsonArray{QJsonValue(QJsonArray{0, 0, 1})});
        row("time runs backwards", "samples",
            QJsonArray{QJsonArray{0, 0, 1, 1}, QJsonArray{0, 0, 1, 0.5}});
    }
    void namesTheFieldThatIsWrong()
    {
        QFETCH(QString, field);
        QFETCH(QJsonValue, value);
        const QJsonObject object = with(parse(drillText), field.split(QLatin1Char('.')), value);
        const Result<Edit> edit = editFromJson(object);
        QVERIFY(!edit);
        QCOMPARE(edit.error().code, ErrorCode::InvalidField);
        QCOMPARE(edit.error().arguments.value(0), QStringLiteral("drill.") + field);
        QVERIFY(!edit.error().arguments.value(1).isEmpty());
    }

    void refusesWrongTexts_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("field");
        QTest::newRow("colour") << QByteArray("{'edit':'addSegment','name':'a','color':'red'}")
                                << QStringLiteral("addSegment.color");
        QTest::newRow("sign in colour")
            << QByteArray("{'edit':'addSegment','name':'a','color':'#+12345'}")
            << QStringLiteral("addSegment.color");
        QTest::newRow("empty name")
            << QByteArray("{'edit':'addSegment','name':' ','color':'#000000'}")
            << QStringLiteral("addSegment.name");
        QTest::newRow("half a code")
            << QByteArray("{'edit':'addSegment','name':'a','color':'#000000','code':['SCT','1']}")
            << QStringLiteral("addSegment.code");
        QTest::newRow("code without meaning") << QByteArray(
            "{'edit':'addSegment','name':'a','color':'#000000','code':['SCT','1','']}")
                                              << QStringLiteral("addSegment.code");
        QTest::newRow("steps") << QByteArray("{'edit':'grow','lower':0,'upper':1,'steps':'all'}")
                               << QStringLiteral("grow.steps");
        QTest::newRow("connectivity")
            << QByteArray("{'edit':'grow','lower':0,'upper':1,'connectivity':14,'steps':1}")
            << QStringLiteral("grow.connectivity");
        QTest::newRow("number too great")
            << QByteArray("{'edit':'grow','lower':0,'upper':1e305,'steps':1}")
            << QStringLiteral("grow.upper");
        QTest::newRow("no name") << QByteArray("{'lower':0}") << QStringLiteral("edit");
    }
    void refusesWrongTexts()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, field);
        QVERIFY(!parse(text).isEmpty());
        const Result<Edit> edit = editFromJson(parse(text));
        QVERIFY(!edit);
        QCOMPARE(edit.error().code, ErrorCode::InvalidField);
        QCOMPARE(edit.error().arguments.value(0), field);
    }

    void refusesNumbersThatAreNone()
    {
        GrowSteps grow{.criteria = {.lower = 0.0, .upper = 1.0}};
        QVERIFY(checkFields(grow));
        grow.criteria.lower = std::numeric_limits<double>::quiet_NaN();
        const Result<void> checked = checkFields(grow);
        QVERIFY(!checked);
        QCOMPARE(checked.error().arguments.value(0), QStringLiteral("grow.lower"));
        grow.criteria.lower = -std::numeric_limits<double>::infinity();
        QVERIFY(!checkFields(grow));
    }

    void aStrokeMayBeginWithoutSamples()
    {
        DrillStroke stroke = editFromJson(parse(drillText))->get<DrillStroke>();
        stroke.samples.clear();
        QVERIFY(checkFieldsAtBegin(stroke));
        QVERIFY(!checkFields(stroke));
    }

    void writesWhatItReads()
    {
        const Result<Edit> edit = editFromJson(parse(drillText));
        QVERIFY(edit);
        const QJsonObject written = editToJson(*edit);
        const Result<Edit> again = editFromJson(written);
        QVERIFY(again);
        QCOMPARE(editToJson(*again), written);
        QCOMPARE(written.value(QStringLiteral("edit")).toString(), QStringLiteral("drill"));
    }

    void restoreIsAToolBackwards()
    {
        QJsonObject drill = parse(drillText);
        drill.insert(QStringLiteral("restore"), true);
        QJsonObject restore = parse(drillText);
        restore.insert(QStringLiteral("edit"), QStringLiteral("restore"));
        QCOMPARE(editFromJson(restore).error().arguments.front(), QStringLiteral("restore.as"));
        restore.insert(QStringLiteral("as"), QStringLiteral("grow"));
        QVERIFY(!editFromJson(restore));
        restore.insert(QStringLiteral("as"), QStringLiteral("drill"));
        QCOMPARE(editToJson(*editFromJson(restore)), editToJson(*editFromJson(drill)));
        restore.insert(QStringLiteral("restore"), false);
        QVERIFY(!editFromJson(restore));
    }

    /// A peel and scissors take a mask as a drill has it, and keep its outline.
    void outlinedToolsTakeMasks()
    {
        const QJsonObject drill = parse(drillText);
        for (const char* tool : {"peel", "scissors"}) {
            QJsonObject cut{{QStringLiteral("edit"), QLatin1String(tool)},
                {QStringLiteral("view"), drill.value(QStringLiteral("view"))},
                {QStringLiteral("surface"), drill.value(QStringLiteral("surface"))},
                {QStringLiteral("depthMm"), 5}};
            const auto outlineOf = [](const Edit& edit) {
                const auto* peel = edit.as<PeelCut>();
                return peel ? peel->polygonMm : edit.get<ScissorsCut>().polygonMm;
            };
            QVERIFY(!editFromJson(cut));
            cut.insert(QStringLiteral("mask"), parse("{'polygonMm':[[0,0],[9,0],[0,9]]}"));
            const Result<Edit> drawn = editFromJson(cut);
            QVERIFY(drawn);
            QCOMPARE(outlineOf(*drawn).size(), std::size_t(3));
            QVERIFY(!editToJson(*drawn).contains(QStringLiteral("mask")));
            cut.insert(QStringLiteral("mask"), parse("{'shape':'circle','radiusMm':8}"));
            const Result<Edit> round = editFromJson(cut);
            QVERIFY(round);
            const std::vector<glm::dvec2> circle = outlineOf(*round);
            QVERIFY(circle.size() > 20);
            for (const glm::dvec2& point : circle)
                QVERIFY(std::abs(glm::length(point) - 8.0) < 1e-6);
            cut.insert(
                QStringLiteral("mask"), parse("{'shape':'circle','radiusMm':8,'softnessMm':2}"));
            QVERIFY(!editFromJson(cut));
            cut.insert(QStringLiteral("mask"), parse("{'shape':'circle','radiusMm':-8}"));
            QVERIFY(editFromJson(cut).error().arguments.front().startsWith(QLatin1String(tool)));
            cut.insert(QStringLiteral("mask"), parse("{'shape':'circle','radiusMm':8}"));
            cut.insert(QStringLiteral("polygonMm"), QJsonArray{});
            QVERIFY(!editFromJson(cut));
        }
    }

    void documentsEveryFieldThatIsWritten()
    {
        // The documentation comes from the same visits: a required field that it does not call
        // optional must be missed when it is not there.
        const QJsonObject written = editToJson(*editFromJson(parse(drillText)));
        int checkedFields = 0;
        for (const EditDocumentation& documentation : editDocumentation()) {
            QVERIFY(!documentation.meaning.isEmpty());
            for (const FieldDocumentation& field : documentation.fields) {
                QVERIFY2(!field.meaning.isEmpty(), qPrintable(field.name));
                QVERIFY2(!field.type.isEmpty(), qPrintable(field.name));
                if (documentation.name != QLatin1String("drill"))
                    continue;
                const QStringList path = field.name.split(QLatin1Char('.'));
                const QJsonObject inside =
                    path.size() > 1 ? written[path.front()].toObject() : written;
                if (!inside.contains(path.back()))
                    continue; // of another shape or mode
                const Result<Edit> edit =
                    editFromJson(with(parse(drillText), path, QJsonValue(QJsonValue::Undefined)));
                QCOMPARE(bool(edit), !field.fallback.isEmpty());
                ++checkedFields;
            }
        }
        QVERIFY(checkedFields > 10);
    }
};

BURIN_TEST(EditJsonTest)

} // namespace editJsonTest

#include "EditJsonTest.moc"
