// The report's texts: one row per text, one column per language. A new language is a new column;
// tests/cli/report_test.py reads this table and asks for all of them.
#pragma once

namespace mien::cli {

inline constexpr const char* kReportLanguages[] = {"en", "de", "fr"};
struct ReportText {
    const char* key;
    const char* in[3];
};

inline constexpr ReportText kReportTexts[] = {
    {"decimal_sign", {".", ",", ","}},
    {"title", {"Volume over time", "Volumen im Verlauf", "Volume au fil du temps"}},
    {"patient", {"Patient", "Patient/in", "Patient"}},
    {"visit", {"Visit", "Besuch", "Visite"}},
    {"visits", {"Visits", "Besuche", "Visites"}},
    {"reference", {"reference", "Ausgangspunkt", "référence"}},
    {"treated", {"Treated", "Behandelt", "Zones traitées"}},
    {"summary", {"What changed", "Was sich verändert hat", "Ce qui a changé"}},
    {"summary_change",
     {"{0}: {1} mL ({2} to {3}) at {4}", "{0}: {1} ml ({2} bis {3}) am Besuch {4}",
      "{0} : {1} ml (de {2} à {3}) à {4}"}},
    {"summary_none",
     {"No zone changed by more than its limit of detection at the last visit.",
      "Beim letzten Besuch hat sich keine Zone um mehr als ihre Nachweisgrenze verändert.",
      "À la dernière visite, aucune zone n'a changé de plus que sa limite de détection."}},
    {"summary_unknown",
     {"Not known at the last visit: {0}", "Beim letzten Besuch nicht bekannt: {0}",
      "Inconnu à la dernière visite : {0}"}},
    {"against", {"Volume against {0}", "Volumen gegenüber {0}", "Volume par rapport à {0}"}},
    {"table_text",
     {"Millilitres, positive: gained. Second line: {0} % interval. Third: limit of detection; what "
      "is grey lies below it and cannot be told from no change.",
      "Milliliter, positiv: zugenommen. Zweite Zeile: {0}-%-Intervall. Dritte: Nachweisgrenze; "
      "Graues liegt darunter und ist von keiner Veränderung nicht zu unterscheiden.",
      "Millilitres, positif : gain. Deuxième ligne : intervalle à {0} %. Troisième : limite de "
      "détection ; ce qui est gris est en dessous et ne se distingue pas d'une absence de "
      "changement."}},
    {"zone", {"Zone", "Zone", "Zone"}},
    {"to", {"{0} to {1}", "{0} bis {1}", "de {0} à {1}"}},
    {"limit", {"limit {0}", "Grenze {0}", "limite {0}"}},
    {"below_limit", {"below the limit {0}", "unter der Grenze {0}", "sous la limite {0}"}},
    {"no_interval", {"no interval: {0}", "kein Intervall: {0}", "pas d'intervalle : {0}"}},
    {"over_time", {"Over time", "Verlauf", "Évolution"}},
    {"plot_text",
     {"Bars: {0} % interval. Grey: below the limit of detection. Hollow dots lie within it.",
      "Balken: {0}-%-Intervall. Grau: unter der Nachweisgrenze. Hohle Punkte liegen darin.",
      "Barres : intervalle à {0} %. Gris : sous la limite de détection. Les points creux s'y "
      "trouvent."}},
    {"plot_of", {"{0} over the visits", "{0} im Verlauf der Besuche", "{0} au fil des visites"}},
    {"no_dates",
     {"Not every visit has a date: the visits stand in their order, not at their distance in time.",
      "Nicht jeder Besuch hat ein Datum: die Besuche stehen in ihrer Reihenfolge, nicht im "
      "zeitlichen Abstand.",
      "Les visites n'ont pas toutes une date : elles sont dans leur ordre, sans leur écart dans le "
      "temps."}},
    {"turn_heading", {"Turn it", "Zum Drehen", "À tourner"}},
    {"turn_text",
     {"Drag to turn, pinch or scroll to come closer; arrow keys and + - do the same.",
      "Ziehen dreht, zwei Finger oder Scrollen holt näher; Pfeiltasten und + - ebenso.",
      "Glisser pour tourner, pincer ou défiler pour approcher ; flèches et + - aussi."}},
    {"turn_none",
     {"This browser draws no 3D (WebGL is off); the pictures below show the same.",
      "Dieser Browser zeichnet kein 3D (WebGL ist aus); die Bilder unten zeigen dasselbe.",
      "Ce navigateur ne dessine pas en 3D (WebGL est désactivé) ; les images ci-dessous montrent "
      "la même chose."}},
    {"turn_label", {"turnable face", "drehbares Gesicht", "visage à tourner"}},
    {"turn_some",
     {"The view holds the first and the last {0} visits.",
      "Die Ansicht enthält den ersten und die letzten {0} Besuche.",
      "La vue contient la première et les {0} dernières visites."}},
    {"show_face", {"Face", "Gesicht", "Visage"}},
    {"show_change", {"Change", "Veränderung", "Changement"}},
    {"scan", {"scan", "Scan", "scan"}},
    {"fit", {"fitted face", "angepasstes Gesicht", "visage ajusté"}},
    {"no_scan",
     {"The scan itself was not given.", "Der Scan selbst wurde nicht angegeben.",
      "Le scan lui-même n'a pas été donné."}},
    {"one_scale",
     {"Scan and fitted face at one scale; outlined: treated.",
      "Scan und angepasstes Gesicht im selben Maßstab; umrandet: behandelt.",
      "Scan et visage ajusté à la même échelle ; contour : zones traitées."}},
    {"one_scale_untreated",
     {"Scan and fitted face at one scale.", "Scan und angepasstes Gesicht im selben Maßstab.",
      "Scan et visage ajusté à la même échelle."}},
    {"change_against",
     {"Change against {0}, mm along the skin's normal",
      "Veränderung gegenüber {0}, mm entlang der "
      "Hautnormale",
      "Changement par rapport à {0}, mm selon la normale de la peau"}},
    {"lost", {"lost", "verloren", "perdu"}},
    {"gained", {"gained", "zugenommen", "gagné"}},
    {"unseen",
     {"grey: not seen, or nothing is known", "grau: nicht gesehen, oder nichts bekannt",
      "gris : non vu, ou rien n'est connu"}},
    {"within_error",
     {"white: within its standard deviation", "weiß: innerhalb der Standardabweichung",
      "blanc : dans son écart-type"}},
    {"without_error",
     {"The errors of these faces are not known: colours may be noise.",
      "Die Fehler dieser Gesichter sind nicht bekannt: Farben können Rauschen sein.",
      "Les erreurs de ces visages sont inconnues : les couleurs peuvent être du bruit."}},
    {"good", {"fit good", "Anpassung gut", "ajustement bon"}},
    {"doubtful", {"fit doubtful", "Anpassung zweifelhaft", "ajustement douteux"}},
    {"failed", {"fit failed", "Anpassung misslungen", "ajustement échoué"}},
    {"fitted_beforehand", {"fitted beforehand", "vorher angepasst", "ajusté au préalable"}},
    {"fit_numbers",
     {"{0} mm from the scan, {1} % of the face seen", "{0} mm vom Scan, {1} % des Gesichts gesehen",
      "à {0} mm du scan, {1} % du visage vu"}},
    {"expected",
     {"expected error of the face {0} mm ({1} to {2})",
      "erwarteter Fehler des Gesichts {0} mm ({1} bis {2})",
      "erreur attendue du visage {0} mm (de {1} à {2})"}},
    {"no_expression", {"no expression", "kein Ausdruck", "aucune expression"}},
    {"unnamed_expression",
     {"an expression without a name taken off", "ein Ausdruck ohne Namen abgezogen",
      "une expression sans nom retirée"}},
    {"expression_off",
     {"expression taken off: {0}", "Ausdruck abgezogen: {0}", "expression retirée : {0}"}},
    {"stable_apart",
     {"stable zone {0} mm apart after alignment",
      "stabile Zone nach Ausrichtung {0} mm auseinander", "zone stable à {0} mm après alignement"}},
    {"captures", {"{0} captures", "{0} Aufnahmen", "{0} prises"}},
    {"reasons", {"Why", "Warum", "Pourquoi"}},
    {"unit_taken",
     {"one unit of the scan was taken for {0} mm",
      "eine Einheit des Scans wurde für {0} mm genommen",
      "une unité du scan a été prise pour {0} mm"}},
    {"how", {"How it was measured", "Wie gemessen wurde", "Comment c'est mesuré"}},
    {"how_fitted",
     {"Faces were fitted beforehand.", "Die Gesichter wurden vorher angepasst.",
      "Les visages ont été ajustés au préalable."}},
    {"how_registered",
     {"Each scan was registered with the template of {0}.",
      "Jeder Scan wurde mit der Vorlage von {0} registriert.",
      "Chaque scan a été recalé avec le modèle de {0}."}},
    {"how_expressions",
     {"Expressions were removed with {0}, from all captures together; what that leaves open widens "
      "the intervals: the fit's posterior and {1} % of the volume that an expression accounted "
      "for.",
      "Ausdrücke wurden mit {0} entfernt, aus allen Aufnahmen gemeinsam; was das offen lässt, "
      "verbreitert die Intervalle: die Unsicherheit der Anpassung und {1} % des Volumens, das ein "
      "Ausdruck ausmachte.",
      "Les expressions ont été retirées avec {0}, de toutes les prises ensemble ; ce qui reste "
      "ouvert élargit les intervalles : l'incertitude de l'ajustement et {1} % du volume dû à une "
      "expression."}},
    {"how_no_expressions",
     {"Expressions were not removed: the intervals hold for faces that are held alike.",
      "Ausdrücke wurden nicht entfernt: die Intervalle gelten für gleich gehaltene Gesichter.",
      "Les expressions n'ont pas été retirées : les intervalles valent pour des visages tenus de "
      "la même façon."}},
    {"how_aligned",
     {"Faces were aligned on: {0}.", "Die Gesichter wurden ausgerichtet an: {0}.",
      "Les visages ont été alignés sur : {0}."}},
    {"whole_face", {"the whole face", "dem ganzen Gesicht", "tout le visage"}},
    {"all_untreated",
     {"all zones but the treated ones and {0} mm around them",
      "allen Zonen außer den behandelten und {0} mm um sie",
      "toutes les zones sauf celles traitées et {0} mm autour"}},
    {"how_treated", {"Treated: {0}.", "Behandelt: {0}.", "Zones traitées : {0}."}},
    {"how_volumes",
     {"Volumes are exact between corresponding triangles; zones share their edge triangles "
      "linearly.",
      "Volumen sind exakt zwischen einander entsprechenden Dreiecken; Zonen teilen sich ihre "
      "Randdreiecke linear.",
      "Les volumes sont exacts entre triangles correspondants ; les zones partagent leurs "
      "triangles de bord linéairement."}},
    {"how_intervals",
     {"Intervals combine the deviations of both fits, alike over {0} mm, the alignment's and a "
      "common bias of {1} mm. Where the errors of a fit are not known, or too little of a zone was "
      "seen, none is given.",
      "Intervalle vereinen die Abweichungen beider Anpassungen, gleichartig über {0} mm, die der "
      "Ausrichtung und einen gemeinsamen Fehler von {1} mm. Wo die Fehler einer Anpassung nicht "
      "bekannt sind oder zu wenig einer Zone gesehen wurde, gibt es keines.",
      "Les intervalles réunissent les écarts des deux ajustements, semblables sur {0} mm, celui de "
      "l'alignement et un biais commun de {1} mm. Là où les erreurs d'un ajustement sont inconnues "
      "ou trop peu d'une zone a été vu, il n'y en a pas."}},
    {"how_limits",
     {"Limits of detection come from {0} pairs of captures of the same visit.",
      "Nachweisgrenzen stammen aus {0} Paaren von Aufnahmen desselben Besuchs.",
      "Les limites de détection viennent de {0} paires de prises de la même visite."}},
    {"how_limits_propagated",
     {"Limits of detection are propagated from the deviations: no visit was captured often enough "
      "to measure them.",
      "Nachweisgrenzen sind aus den Abweichungen fortgepflanzt: kein Besuch wurde oft genug "
      "aufgenommen, um sie zu messen.",
      "Les limites de détection sont propagées à partir des écarts : aucune visite n'a été prise "
      "assez souvent pour les mesurer."}},
    {"how_colors",
     {"Colours show where the skin moved by more than its own standard deviation; grey skin was "
      "not seen in one of the visits, or nothing is known there, and takes no part in the range "
      "of the colours. Whether a zone changed is for the table to say.",
      "Farben zeigen, wo sich die Haut um mehr als ihre eigene Standardabweichung bewegt hat; "
      "graue Haut wurde bei einem der Besuche nicht gesehen, oder es ist dort nichts bekannt, und "
      "sie bestimmt den Farbbereich nicht mit. Ob sich eine Zone verändert hat, sagt die Tabelle.",
      "Les couleurs montrent où la peau a bougé de plus que son propre écart-type ; la peau grise "
      "n'a pas été vue à l'une des visites, ou rien n'y est connu, et ne compte pas dans l'échelle "
      "des couleurs. C'est le tableau qui dit si une zone a changé."}},
    {"made_with", {"Made with", "Erstellt mit", "Réalisé avec"}},
    {"software", {"Software", "Software", "Logiciel"}},
    {"model", {"Model", "Modell", "Modèle"}},
    {"expression_model", {"Expression model", "Ausdrucksmodell", "Modèle d'expressions"}},
    {"sha256", {"SHA-256", "SHA-256", "SHA-256"}},
    {"file", {"File", "Datei", "Fichier"}},
    {"reviewed",
     {"Reviewed by (name, signature, date)", "Geprüft von (Name, Unterschrift, Datum)",
      "Vérifié par (nom, signature, date)"}},
    {"zone_and_around",
     {"{0} and {1} mm around", "{0} und {1} mm darum herum", "{0} et {1} mm autour"}},
};

/// By the names that zones have in files.
inline constexpr ReportText kZoneNames[] = {
    {"face", {"face", "Gesicht", "visage"}},
    {"forehead", {"forehead", "Stirn", "front"}},
    {"glabella", {"glabella", "Glabella", "glabelle"}},
    {"nose", {"nose", "Nase", "nez"}},
    {"mouth", {"mouth", "Mund", "bouche"}},
    {"lips", {"lips", "Lippen", "lèvres"}},
    {"upper_lip", {"upper lip", "Oberlippe", "lèvre supérieure"}},
    {"lower_lip", {"lower lip", "Unterlippe", "lèvre inférieure"}},
    {"chin", {"chin", "Kinn", "menton"}},
    {"neck", {"neck", "Hals", "cou"}},
    {"scalp", {"scalp", "Kopfhaut", "cuir chevelu"}},
    {"cheek_left", {"left cheek", "linke Wange", "joue gauche"}},
    {"cheek_right", {"right cheek", "rechte Wange", "joue droite"}},
    {"eye_left", {"left eye", "linkes Auge", "œil gauche"}},
    {"eye_right", {"right eye", "rechtes Auge", "œil droit"}},
    {"eyelid_left", {"left eyelid", "linkes Augenlid", "paupière gauche"}},
    {"eyelid_right", {"right eyelid", "rechtes Augenlid", "paupière droite"}},
    {"brow_left", {"left brow", "linke Braue", "sourcil gauche"}},
    {"brow_right", {"right brow", "rechte Braue", "sourcil droit"}},
    {"temple_left", {"left temple", "linke Schläfe", "tempe gauche"}},
    {"temple_right", {"right temple", "rechte Schläfe", "tempe droite"}},
    {"ear_left", {"left ear", "linkes Ohr", "oreille gauche"}},
    {"ear_right", {"right ear", "rechtes Ohr", "oreille droite"}},
    {"jaw_left", {"left jaw", "linker Kiefer", "mâchoire gauche"}},
    {"jaw_right", {"right jaw", "rechter Kiefer", "mâchoire droite"}},
    {"nasolabial_left",
     {"left nasolabial fold", "linke Nasolabialfalte", "sillon nasogénien gauche"}},
    {"nasolabial_right",
     {"right nasolabial fold", "rechte Nasolabialfalte", "sillon nasogénien droit"}},
};

/// Fields of patient.json and visit.json.
inline constexpr ReportText kFieldNames[] = {
    {"name", {"Name", "Name", "Nom"}},
    {"id", {"Number", "Nummer", "Numéro"}},
    {"born", {"Born", "Geboren", "Né(e) le"}},
    {"sex", {"Sex", "Geschlecht", "Sexe"}},
    {"clinic", {"Clinic", "Klinik", "Clinique"}},
    {"physician", {"Physician", "Ärztin/Arzt", "Médecin"}},
    {"diagnosis", {"Diagnosis", "Diagnose", "Diagnostic"}},
    {"treatment", {"Treatment", "Behandlung", "Traitement"}},
    {"note", {"Note", "Bemerkung", "Remarque"}},
    {"operator", {"Operator", "Aufnahme durch", "Opérateur"}},
    {"device", {"Device", "Gerät", "Appareil"}},
    {"date", {"Date", "Datum", "Date"}},
};

}  // namespace mien::cli
