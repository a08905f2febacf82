// The report's sentences about fits and visits, which the library and the command say in English:
// one row per sentence, one column per language (report_texts.hpp). tests/cli/report_test.py asks
// for every sentence that a registration can say.
#pragma once

#include "report_texts.hpp"

namespace mien::cli {

/// What the library says; "*" stands for a number, a zone or a sentence of this table.
inline constexpr ReportText kSentences[] = {
    {"tied to the reference visit by texture: the pictures agree on a share of * of the skin seen "
     "twice, and held places slid by * mm (median)",
     {"tied to the reference visit by texture: the pictures agree on a share of {0} of the skin "
      "seen "
      "twice, and held places slid by {1} mm (median)",
      "über die Textur an den früheren Besuch gebunden: die Bilder stimmen auf einem Anteil von "
      "{0} "
      "der zweimal gesehenen Haut überein, gehaltene Orte glitten um {1} mm (Median)",
      "lié à la visite de référence par la texture : les images concordent sur une part de {0} de "
      "la "
      "peau vue deux fois, les points tenus ont glissé de {1} mm (médiane)"}},
    {"not tied to the reference visit, nothing moved: *",
     {"not tied to the reference visit, nothing moved: {0}",
      "nicht an den früheren Besuch gebunden, nichts wurde bewegt: {0}",
      "non lié à la visite de référence, rien n'a bougé : {0}"}},
    {"too little of the skin (a share of *) is seen in colour and near the fit at both visits: "
     "give "
     "scans of the same part of the face",
     {"too little of the skin (a share of {0}) is seen in colour and near the fit at both visits: "
      "give scans of the same part of the face",
      "zu wenig der Haut (ein Anteil von {0}) ist bei beiden Besuchen in Farbe und nahe der "
      "Anpassung zu sehen: Scans desselben Teils des Gesichts angeben",
      "trop peu de la peau (une part de {0}) est vue en couleur et près de l'ajustement aux deux "
      "visites : donnez des scans de la même partie du visage"}},
    {"the two pictures agree on a share of only * of the skin: another person, skin without "
     "detail, "
     "blurred pictures or very unlike light",
     {"the two pictures agree on a share of only {0} of the skin: another person, skin without "
      "detail, blurred pictures or very unlike light",
      "die beiden Bilder stimmen nur auf einem Anteil von {0} der Haut überein: eine andere "
      "Person, "
      "Haut ohne Einzelheiten, unscharfe Bilder oder sehr anderes Licht",
      "les deux images ne concordent que sur une part de {0} de la peau : une autre personne, une "
      "peau sans détail, des images floues ou une lumière très différente"}},
    {"too little of the zone was seen in one of the visits",
     {"too little of the zone was seen in one of the visits",
      "zu wenig der Zone wurde bei einem der Besuche gesehen",
      "trop peu de la zone a été vu à l'une des visites"}},
    {"the fit of one of the visits failed",
     {"the fit of one of the visits failed", "die Anpassung eines der Besuche ist misslungen",
      "l'ajustement de l'une des visites a échoué"}},
    {"the surfaces' errors are unknown",
     {"the surfaces' errors are unknown", "die Fehler der Oberflächen sind nicht bekannt",
      "les erreurs des surfaces sont inconnues"}},
    {"the zone lies outside what the expression model covers",
     {"the zone lies outside what the expression model covers",
      "die Zone liegt außerhalb dessen, was das Ausdrucksmodell umfasst",
      "la zone est hors de ce que couvre le modèle d'expressions"}},
    {"the scan covers only a share of * of the template",
     {"the scan covers only a share of {0} of the template",
      "der Scan deckt nur einen Anteil von {0} der Vorlage ab",
      "le scan ne couvre qu'une part de {0} du modèle"}},
    {"only a share of * of the fitted vertices lies on the scan",
     {"only a share of {0} of the fitted vertices lies on the scan",
      "nur ein Anteil von {0} der angepassten Punkte liegt auf dem Scan",
      "seule une part de {0} des points ajustés est sur le scan"}},
    {"the fitted surface stays * mm away from the scan on average",
     {"the fitted surface stays {0} mm away from the scan on average",
      "die angepasste Oberfläche bleibt im Mittel {0} mm vom Scan entfernt",
      "la surface ajustée reste en moyenne à {0} mm du scan"}},
    {"the landmarks end * mm from the fitted ones",
     {"the landmarks end {0} mm from the fitted ones",
      "die Landmarken enden {0} mm neben den angepassten",
      "les repères finissent à {0} mm de ceux ajustés"}},
    {"the size is implausible (logarithm of the ratio to the template: *)",
     {"the size is implausible (logarithm of the ratio to the template: {0})",
      "die Größe ist unplausibel (Logarithmus des Verhältnisses zur Vorlage: {0})",
      "la taille n'est pas plausible (logarithme du rapport au modèle : {0})"}},
    {"the shape is implausible (* standard deviations of the prior)",
     {"the shape is implausible ({0} standard deviations of the prior)",
      "die Form ist unplausibel ({0} Standardabweichungen)",
      "la forme n'est pas plausible ({0} écarts-types)"}},
    {"* triangles are folded over",
     {"{0} triangles are folded over", "{0} Dreiecke sind umgefaltet",
      "{0} triangles sont repliés"}},
    {"about * mm (* to *) off are expected of the *: *",
     {"about {0} mm ({1} to {2}) off are expected of the {3}: {4}",
      "etwa {0} mm ({1} bis {2}) daneben sind zu erwarten, {3}: {4}",
      "environ {0} mm (de {1} à {2}) d'erreur attendus, {3} : {4}"}},
    {"the scan does not show enough of it: scan the whole face, uncovered",
     {"the scan does not show enough of it: scan the whole face, uncovered",
      "der Scan zeigt zu wenig davon: das ganze Gesicht unbedeckt scannen",
      "le scan n'en montre pas assez : scannez tout le visage, découvert"}},
    {"the scan lies off the model's shape there: is something in front of the skin, or the face "
     "unlike those that the model knows? Landmarks would help",
     {"the scan lies off the model's shape there: is something in front of the skin, or the face "
      "unlike those that the model knows? Landmarks would help",
      "der Scan liegt dort neben der Form des Modells: ist etwas vor der Haut, oder das Gesicht "
      "anders als die, die das Modell kennt? Landmarken würden helfen",
      "le scan s'écarte là de la forme du modèle : quelque chose devant la peau, ou un visage "
      "différent de ceux que le modèle connaît ? Des repères aideraient"}},
    {"its surface faces otherwise than the scan's: pick landmarks there",
     {"its surface faces otherwise than the scan's: pick landmarks there",
      "seine Oberfläche ist anders gerichtet als die des Scans: dort Landmarken setzen",
      "sa surface est orientée autrement que celle du scan : placez-y des repères"}},
    {"little tells where along the skin its places are: pick landmarks there, or use a trained "
     "model",
     {"little tells where along the skin its places are: pick landmarks there, or use a trained "
      "model",
      "wenig sagt, wo auf der Haut seine Stellen liegen: dort Landmarken setzen oder ein "
      "trainiertes "
      "Modell verwenden",
      "peu indique où ses points sont sur la peau : placez-y des repères ou utilisez un modèle "
      "entraîné"}},
    {"it is stretched unlike a face: check the landmarks, or pick more",
     {"it is stretched unlike a face: check the landmarks, or pick more",
      "es ist anders gedehnt als ein Gesicht: Landmarken prüfen oder mehr setzen",
      "il est étiré autrement qu'un visage : vérifiez les repères ou placez-en davantage"}},
    {"the landmarks and the surface disagree: check how they were picked, and the stated picking "
     "error",
     {"the landmarks and the surface disagree: check how they were picked, and the stated picking "
      "error",
      "Landmarken und Oberfläche widersprechen sich: prüfen, wie sie gesetzt wurden, und den "
      "angegebenen Fehler dabei",
      "les repères et la surface se contredisent : vérifiez leur placement et l'erreur indiquée"}},
    {"no pose agrees well with a face: is this one, whole and in the right unit? Landmarks would "
     "tell",
     {"no pose agrees well with a face: is this one, whole and in the right unit? Landmarks would "
      "tell",
      "keine Lage stimmt gut mit einem Gesicht überein: ist es eines, ganz und in der richtigen "
      "Einheit? Landmarken würden es sagen",
      "aucune pose ne correspond bien à un visage : en est-ce un, entier et dans la bonne unité ? "
      "Des repères le diraient"}},
    {"brows or lips are not seen where the form has them: make-up, light, or a wrong fit; "
     "landmarks "
     "would tell",
     {"brows or lips are not seen where the form has them: make-up, light, or a wrong fit; "
      "landmarks would tell",
      "Brauen oder Lippen sind nicht dort zu sehen, wo die Form sie hat: Schminke, Licht oder eine "
      "falsche Anpassung; Landmarken würden es sagen",
      "sourcils ou lèvres ne sont pas vus là où la forme les place : maquillage, lumière ou "
      "mauvais "
      "ajustement ; des repères le diraient"}},
    {"no colours tell where brows and lips are: landmarks there would",
     {"no colours tell where brows and lips are: landmarks there would",
      "keine Farben sagen, wo Brauen und Lippen sind: Landmarken dort würden es",
      "aucune couleur ne dit où sont sourcils et lèvres : des repères le diraient"}},
    {"the shape is unlike those that the model knows: check the unit, the landmarks and the model",
     {"the shape is unlike those that the model knows: check the unit, the landmarks and the model",
      "die Form ist anders als die, die das Modell kennt: Einheit, Landmarken und Modell prüfen",
      "la forme diffère de celles que le modèle connaît : vérifiez l'unité, les repères et le "
      "modèle"}},
    {"triangles are folded over: check the landmarks and the scan",
     {"triangles are folded over: check the landmarks and the scan",
      "Dreiecke sind umgefaltet: Landmarken und Scan prüfen",
      "des triangles sont repliés : vérifiez les repères et le scan"}},
    {"the whole fit is doubtful",
     {"the whole fit is doubtful", "die ganze Anpassung ist zweifelhaft",
      "tout l'ajustement est douteux"}},
    {"the scan's triangles face inwards: it is inside out, or mirrored (left and right exchanged)",
     {"the scan's triangles face inwards: it is inside out, or mirrored (left and right exchanged)",
      "die Dreiecke des Scans zeigen nach innen: er ist umgestülpt oder gespiegelt (links und "
      "rechts vertauscht)",
      "les triangles du scan sont tournés vers l'intérieur : il est retourné ou en miroir (gauche "
      "et droite échangées)"}},
    {"landmarks that contradict the others were left out: *",
     {"landmarks that contradict the others were left out: {0}",
      "Landmarken, die den anderen widersprechen, wurden ausgelassen: {0}",
      "des repères qui contredisent les autres ont été écartés : {0}"}},
    {"colours that do not lie as the form does were left out: *",
     {"colours that do not lie as the form does were left out: {0}",
      "Farben, die nicht wie die Form liegen, wurden ausgelassen: {0}",
      "des couleurs qui ne suivent pas la forme ont été écartées : {0}"}},
    {"no face was found in any pose that agrees well enough (* of 1): is this a face, whole and in "
     "the right unit? Landmarks would tell",
     {"no face was found in any pose that agrees well enough ({0} of 1): is this a face, whole and "
      "in the right unit? Landmarks would tell",
      "in keiner Lage wurde ein Gesicht gefunden, das gut genug übereinstimmt ({0} von 1): ist es "
      "ein Gesicht, ganz und in der richtigen Einheit? Landmarken würden es sagen",
      "aucune pose ne donne un visage qui correspond assez ({0} sur 1) : est-ce un visage, entier "
      "et dans la bonne unité ? Des repères le diraient"}},
    {"neither the pose nor the fit is like that of a face: half a face, or none, lies anywhere; "
     "give landmarks",
     {"neither the pose nor the fit is like that of a face: half a face, or none, lies anywhere; "
      "give landmarks",
      "weder Lage noch Anpassung sind wie bei einem Gesicht: ein halbes Gesicht oder keines liegt "
      "irgendwo; Landmarken angeben",
      "ni la pose ni l'ajustement ne sont ceux d'un visage : un demi-visage, ou aucun, se place "
      "n'importe où ; donnez des repères"}},
    {"two pieces of the scan, of * and * triangles, lie over each other: two scans in one file, or "
     "a double shell; keep one of them, since the fit follows either",
     {"two pieces of the scan, of {0} and {1} triangles, lie over each other: two scans in one "
      "file, or a double shell; keep one of them, since the fit follows either",
      "zwei Stücke des Scans, mit {0} und {1} Dreiecken, liegen übereinander: zwei Scans in einer "
      "Datei oder eine doppelte Schale; nur eines behalten, da die Anpassung mal dem einen, mal "
      "dem anderen folgt",
      "deux morceaux du scan, de {0} et {1} triangles, se superposent : deux scans dans un fichier "
      "ou une double coque ; n'en gardez qu'un, car l'ajustement suit l'un ou l'autre"}},
    {"the scan has a second piece of * triangles * mm beside the largest of *: if it is another "
     "face, check which of them was fitted, or cut it off",
     {"the scan has a second piece of {0} triangles {1} mm beside the largest of {2}: if it is "
      "another face, check which of them was fitted, or cut it off",
      "der Scan hat ein zweites Stück von {0} Dreiecken, {1} mm neben dem größten von {2}: ist es "
      "ein anderes Gesicht, prüfen, welches angepasst wurde, oder es abschneiden",
      "le scan a un second morceau de {0} triangles à {1} mm du plus grand, de {2} : si c'est un "
      "autre visage, vérifiez lequel a été ajusté, ou coupez-le"}},
    {"no known unit fits the scan: one unit was taken for * mm, as if the face were as large as "
     "the template; lengths and volumes are a guess until the unit is given or the scan is scaled "
     "to mm",
     {"no known unit fits the scan: one unit was taken for {0} mm, as if the face were as large as "
      "the template; lengths and volumes are a guess until the unit is given or the scan is scaled "
      "to mm",
      "keine bekannte Einheit passt zum Scan: eine Einheit wurde für {0} mm genommen, als wäre das "
      "Gesicht so groß wie die Vorlage; Längen und Volumen sind geraten, bis die Einheit angegeben "
      "oder der Scan in mm umgerechnet ist",
      "aucune unité connue ne convient au scan : une unité a été prise pour {0} mm, comme si le "
      "visage avait la taille du modèle ; longueurs et volumes sont devinés tant que l'unité n'est "
      "pas donnée ou le scan converti en mm"}},
    {"the landmarks are in another unit than the scan (landmarks in *, scan in *): both were "
     "brought to mm; the landmarks were turned by half a turn about z to lie on the scan (RAS and "
     "LPS)",
     {"the landmarks are in another unit than the scan (landmarks in {0}, scan in {1}): both were "
      "brought to mm; the landmarks were turned by half a turn about z to lie on the scan (RAS and "
      "LPS)",
      "die Landmarken sind in einer anderen Einheit als der Scan (Landmarken in {0}, Scan in {1}): "
      "beide wurden in mm umgerechnet; die Landmarken wurden um eine halbe Drehung um z gedreht, "
      "um auf dem Scan zu liegen (RAS und LPS)",
      "les repères sont dans une autre unité que le scan (repères en {0}, scan en {1}) : les deux "
      "ont été convertis en mm ; les repères ont été tournés d'un demi-tour autour de z pour "
      "tomber sur le scan (RAS et LPS)"}},
    {"the landmarks are in another unit than the scan (landmarks in *, scan in *): both were "
     "brought to mm",
     {"the landmarks are in another unit than the scan (landmarks in {0}, scan in {1}): both were "
      "brought to mm",
      "die Landmarken sind in einer anderen Einheit als der Scan (Landmarken in {0}, Scan in {1}): "
      "beide wurden in mm umgerechnet",
      "les repères sont dans une autre unité que le scan (repères en {0}, scan en {1}) : les deux "
      "ont été convertis en mm"}},
    {"the landmarks were turned by half a turn about z to lie on the scan (RAS and LPS)",
     {"the landmarks were turned by half a turn about z to lie on the scan (RAS and LPS)",
      "die Landmarken wurden um eine halbe Drehung um z gedreht, um auf dem Scan zu liegen (RAS "
      "und LPS)",
      "les repères ont été tournés d'un demi-tour autour de z pour tomber sur le scan (RAS et "
      "LPS)"}},
    {"the landmarks are mirrored: left and right are exchanged in their names, or the scan itself "
     "is mirrored; they were exchanged back",
     {"the landmarks are mirrored: left and right are exchanged in their names, or the scan itself "
      "is mirrored; they were exchanged back",
      "die Landmarken sind gespiegelt: links und rechts sind in ihren Namen vertauscht, oder der "
      "Scan selbst ist gespiegelt; sie wurden zurückgetauscht",
      "les repères sont en miroir : gauche et droite sont échangées dans leurs noms, ou le scan "
      "lui-même est en miroir ; l'échange a été annulé"}},
    {"the landmarks * are mirrored: left and right are exchanged in their names; they were "
     "exchanged back",
     {"the landmarks {0} are mirrored: left and right are exchanged in their names; they were "
      "exchanged back",
      "die Landmarken {0} sind gespiegelt: links und rechts sind in ihren Namen vertauscht; sie "
      "wurden zurückgetauscht",
      "les repères {0} sont en miroir : gauche et droite sont échangées dans leurs noms ; "
      "l'échange a été annulé"}},
    {"the landmarks lie * mm from the face, all to one side: they were moved back by that; were "
     "they picked on this scan, and in its frame?",
     {"the landmarks lie {0} mm from the face, all to one side: they were moved back by that; were "
      "they picked on this scan, and in its frame?",
      "die Landmarken liegen {0} mm neben dem Gesicht, alle nach derselben Seite: sie wurden um so "
      "viel zurückgeschoben; wurden sie auf diesem Scan und in seinem Koordinatensystem gesetzt?",
      "les repères se trouvent à {0} mm du visage, tous du même côté : ils ont été ramenés "
      "d'autant ; ont-ils été posés sur ce scan, et dans son repère de coordonnées ?"}},
    {"by its landmarks the face is outside of what the trained modes span: fitted by the kernel "
     "alone",
     {"by its landmarks the face is outside of what the trained modes span: fitted by the kernel "
      "alone",
      "nach seinen Landmarken liegt das Gesicht außerhalb dessen, was die trainierten Moden "
      "aufspannen: nur mit dem Kern angepasst",
      "d'après ses repères, le visage est hors de ce que couvrent les modes appris : ajusté par le "
      "noyau seul"}},
    {"by its surface the face is outside of what the trained modes span: fitted by the kernel "
     "alone",
     {"by its surface the face is outside of what the trained modes span: fitted by the kernel "
      "alone",
      "nach seiner Oberfläche liegt das Gesicht außerhalb dessen, was die trainierten Moden "
      "aufspannen: nur mit dem Kern angepasst",
      "d'après sa surface, le visage est hors de ce que couvrent les modes appris : ajusté par le "
      "noyau seul"}},
    {"*: is the same face as *, so nothing has changed; is one file there twice?",
     {"{0}: is the same face as {1}, so nothing has changed; is one file there twice?",
      "{0}: ist dasselbe Gesicht wie {1}, also hat sich nichts verändert; liegt eine Datei doppelt "
      "da?",
      "{0} : est le même visage que {1}, donc rien n'a changé ; un fichier est-il là deux fois ?"}},
    {"the stable zones of * lie * mm from those of * once they are aligned: is it the same person, "
     "and has nothing changed there?",
     {"the stable zones of {0} lie {1} mm from those of {2} once they are aligned: is it the same "
      "person, and has nothing changed there?",
      "die stabilen Zonen von {0} liegen nach der Ausrichtung {1} mm neben denen von {2}: ist es "
      "dieselbe Person, und hat sich dort nichts verändert?",
      "les zones stables de {0} sont à {1} mm de celles de {2} après alignement : est-ce la même "
      "personne, et rien n'y a-t-il changé ?"}},
    {"the face of * is * % larger than that of * by its stable zones: is it the same person, "
     "and are both scans in one unit and calibrated?",
     {"the face of {0} is {1} % larger than that of {2} by its stable zones: is it the same "
      "person, and are both scans in one unit and calibrated?",
      "das Gesicht von {0} ist {1} % größer als das von {2}, nach seinen stabilen Zonen: ist es "
      "dieselbe Person, und sind beide Scans in einer Einheit und kalibriert?",
      "le visage de {0} est de {1} % plus grand que celui de {2} par ses zones stables : "
      "est-ce la même personne, et les deux scans sont-ils dans une même unité et calibrés ?"}},
    {"the face of * is * % smaller than that of * by its stable zones: is it the same person, "
     "and are both scans in one unit and calibrated?",
     {"the face of {0} is {1} % smaller than that of {2} by its stable zones: is it the same "
      "person, and are both scans in one unit and calibrated?",
      "das Gesicht von {0} ist {1} % kleiner als das von {2}, nach seinen stabilen Zonen: ist "
      "es dieselbe Person, und sind beide Scans in einer Einheit und kalibriert?",
      "le visage de {0} est de {1} % plus petit que celui de {2} par ses zones stables : "
      "est-ce la même personne, et les deux scans sont-ils dans une même unité et calibrés ?"}},
    {"* landmarks are unknown to the model and left out: *",
     {"{0} landmarks are unknown to the model and left out: {1}",
      "{0} Landmarken kennt das Modell nicht, sie wurden ausgelassen: {1}",
      "{0} repères sont inconnus du modèle et écartés : {1}"}},
};

}  // namespace mien::cli
