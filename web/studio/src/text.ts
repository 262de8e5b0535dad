// Texts in English and German. A sentence of the server's stays in English.
const en = {
    create: 'Create', scenes: 'Scenes', language: 'Language', skip: 'Skip to the content',
    lead: 'Describe a room. Walk in it minutes later.',
    sentence: 'Your sentence', placeholder: 'a cozy bedroom with a red armchair and a large window',
    enter: 'Enter makes the scene, Shift + Enter begins a new line.',
    examples: 'Try one of these', understood: 'understood', approximated: 'taken as something near',
    not_understood: 'not understood', not_placed: 'no place found', assumed: 'chosen for you',
    reading: 'What is understood', plan: 'Floor plan', plan_of: 'Floor plan of the room that this sentence makes',
    plan_waits: 'The plan of your room is drawn here while you type.', metres: 'm', high: 'high',
    style: 'Style', hour: 'Time of day', as_said: 'as the sentence says', seed: 'Seed', dice: 'Another room',
    seed_help: 'The same sentence and seed make the same room.',
    quality: 'Quality', draft: 'Draft', standard: 'Standard', high_quality: 'High', draft_for: 'to try an idea',
    standard_for: 'to walk in', high_for: 'for close looks', about: 'about', min: 'min', memory: 'memory',
    low_memory: 'This machine has {0} GB free: close other programs first.',
    measured: 'as measured on this machine', estimated: 'estimate for this machine',
    own: 'Use my own 360° panorama', own_help: 'Drop a 2:1 picture here, or choose one. JPEG, PNG, WebP, TIFF, HDR or EXR.',
    choose: 'Choose a file', range: 'Range map (optional)', remove_file: 'Remove the file',
    too_large: '{0} is larger than {1} MB: make it smaller.', checking: 'Looking at {0} …',
    make: 'Make this scene', queue: 'In the making', stop: 'Stop', resume: 'Resume', forget: 'Discard',
    first: 'Do this next', waiting: 'waits its turn', running: 'is made', stopped: 'stopped', failed: 'failed',
    finished: 'finished', left: 'left', open: 'Walk in', starting: 'starting', retry: 'Try again',
    look_alt: 'A first, coarse look at the room', panorama_alt: 'The panorama of the room',
    works: {
        look: 'a first look', panorama: 'light is traced', depth: 'distances', walk: 'a walk through the room',
        views: 'views are cut', splat: 'splats are trained', share: 'the page is written',
    } as Record<string, string>,
    empty: 'No scenes yet. Write a sentence, press Enter.', search: 'Search scenes', found: '{0} of {1} scenes',
    nothing_found: 'No scene has these words.', delete: 'Delete', deleted: '“{0}” is in the trash.', undo: 'Undo',
    unfinished: 'unfinished', complete: 'Finish it', changed: 'changed', truth: '{0} dB against the true room',
    walk: 'Walk', panorama: 'Panorama', change: 'Plan & changes', files: 'Files', back: 'All scenes',
    walk_keys: 'W A S D or arrows to walk, drag to look around, Shift to run. On a phone: left thumb walks, right thumb looks.',
    new_window: 'Open in a window of its own', no_webgl: 'This browser shows no 3D (WebGL 2 is off): here is the panorama as a picture.',
    no_walk: 'This scene has no page to walk in yet.', full: 'Full screen',
    panorama_help: 'Drag or use the arrow keys to look around; + and − zoom.',
    compare: 'Before and after', before: 'before', after: 'after',
    select: 'Things in the room', selected: 'Selected', nothing_selected: 'Select a thing in the plan, or change the room.',
    turn: 'Turn', turn_left: 'Turn left', turn_right: 'Turn right', move_help: 'Arrow keys move it by 5 cm, R turns it, Del removes it.',
    color: 'Color', custom: 'Own color', material: 'Material', as_is: 'as it is', remove: 'Remove', room: 'The room',
    walls: 'Walls', floor: 'Floor', add: 'Add a thing', add_hint: 'a floor lamp beside the bed', add_do: 'Add',
    say: 'Or say it', say_hint: 'move the armchair to the window, make it blue', say_do: 'Do it',
    changes: 'Changes', no_changes: 'Nothing is changed yet. This scene stays; changes make a new one.',
    redo: 'Redo', reset: 'Start over', remake: 'Make it anew', remade: 'The changed room is in the making.',
    no_room: 'This scene was made from pictures: there is no known room to change.',
    download: 'Download', on_demand: 'made on demand', preparing: 'preparing …', command: 'The same on the command line',
    copy: 'Copy', copied: 'Copied.', groups: { share: 'To share', splats: 'Splats', room: 'For engines', data: 'Data' } as Record<string, string>,
    file: 'File', size: 'Size', what_for: 'For', shown_command: 'Command', lost: 'This page does not exist.', lost_scene: 'There is no scene of this name.',
    offline: 'The studio does not answer. Is it still running? What is made goes on when it starts again.',
    close: 'Close', facts: 'Facts', made_in: 'made in', peak: 'peak memory', from: 'made from', walls_alt: 'wall',
    saved_later: 'Your changes are kept until you make them or start over.', licenses: 'Licences',
};
const de: typeof en = {
    create: 'Neu', scenes: 'Szenen', language: 'Sprache', skip: 'Zum Inhalt',
    lead: 'Beschreibe einen Raum. Minuten später gehst du darin umher.',
    sentence: 'Dein Satz', placeholder: 'ein gemütliches Schlafzimmer mit rotem Sessel und großem Fenster',
    enter: 'Enter macht die Szene, Umschalt + Enter beginnt eine neue Zeile.',
    examples: 'Zum Ausprobieren', understood: 'verstanden', approximated: 'als etwas Ähnliches verstanden',
    not_understood: 'nicht verstanden', not_placed: 'kein Platz gefunden', assumed: 'für dich gewählt',
    reading: 'Was verstanden wird', plan: 'Grundriss', plan_of: 'Grundriss des Raums, den dieser Satz ergibt',
    plan_waits: 'Hier entsteht der Grundriss, während du schreibst.', metres: 'm', high: 'hoch',
    style: 'Stil', hour: 'Tageszeit', as_said: 'wie im Satz', seed: 'Startwert', dice: 'Anderer Raum',
    seed_help: 'Gleicher Satz und gleicher Startwert ergeben den gleichen Raum.',
    quality: 'Qualität', draft: 'Entwurf', standard: 'Standard', high_quality: 'Hoch', draft_for: 'für eine Idee',
    standard_for: 'zum Begehen', high_for: 'für nahe Blicke', about: 'etwa', min: 'Min.', memory: 'Speicher',
    low_memory: 'Hier sind {0} GB frei: bitte vorher andere Programme schließen.',
    measured: 'auf diesem Rechner gemessen', estimated: 'Schätzung für diesen Rechner',
    own: 'Eigenes 360°-Panorama verwenden', own_help: 'Ein 2:1-Bild hierher ziehen oder auswählen. JPEG, PNG, WebP, TIFF, HDR oder EXR.',
    choose: 'Datei wählen', range: 'Entfernungskarte (freiwillig)', remove_file: 'Datei entfernen',
    too_large: '{0} ist größer als {1} MB: bitte verkleinern.', checking: '{0} wird angesehen …',
    make: 'Szene machen', queue: 'In Arbeit', stop: 'Anhalten', resume: 'Fortsetzen', forget: 'Verwerfen',
    first: 'Als Nächstes', waiting: 'wartet', running: 'entsteht', stopped: 'angehalten', failed: 'gescheitert',
    finished: 'fertig', left: 'übrig', open: 'Hineingehen', starting: 'beginnt', retry: 'Noch einmal',
    look_alt: 'Ein erster, grober Blick in den Raum', panorama_alt: 'Das Panorama des Raums',
    works: {
        look: 'ein erster Blick', panorama: 'Licht wird verfolgt', depth: 'Entfernungen', walk: 'ein Gang durch den Raum',
        views: 'Ansichten entstehen', splat: 'Splats werden trainiert', share: 'die Seite wird geschrieben',
    },
    empty: 'Noch keine Szenen. Schreib einen Satz und drück Enter.', search: 'Szenen suchen', found: '{0} von {1} Szenen',
    nothing_found: 'Keine Szene hat diese Wörter.', delete: 'Löschen', deleted: '„{0}“ liegt im Papierkorb.', undo: 'Rückgängig',
    unfinished: 'unfertig', complete: 'Fertigstellen', changed: 'geändert', truth: '{0} dB gegen den wahren Raum',
    walk: 'Begehen', panorama: 'Panorama', change: 'Plan & Änderungen', files: 'Dateien', back: 'Alle Szenen',
    walk_keys: 'W A S D oder Pfeiltasten zum Gehen, ziehen zum Umsehen, Umschalt zum Laufen. Am Telefon: linker Daumen geht, rechter schaut.',
    new_window: 'In eigenem Fenster öffnen', no_webgl: 'Dieser Browser zeigt kein 3D (WebGL 2 ist aus): hier ist das Panorama als Bild.',
    no_walk: 'Diese Szene hat noch keine begehbare Seite.', full: 'Vollbild',
    panorama_help: 'Ziehen oder Pfeiltasten zum Umsehen; + und − zoomen.',
    compare: 'Vorher und nachher', before: 'vorher', after: 'nachher',
    select: 'Dinge im Raum', selected: 'Ausgewählt', nothing_selected: 'Wähle ein Ding im Plan oder ändere den Raum.',
    turn: 'Drehen', turn_left: 'Nach links drehen', turn_right: 'Nach rechts drehen', move_help: 'Pfeiltasten schieben um 5 cm, R dreht, Entf entfernt.',
    color: 'Farbe', custom: 'Eigene Farbe', material: 'Material', as_is: 'wie es ist', remove: 'Entfernen', room: 'Der Raum',
    walls: 'Wände', floor: 'Boden', add: 'Etwas hinzufügen', add_hint: 'a floor lamp beside the bed', add_do: 'Hinzufügen',
    say: 'Oder sag es (auf Englisch)', say_hint: 'move the armchair to the window, make it blue', say_do: 'Tun',
    changes: 'Änderungen', no_changes: 'Noch nichts geändert. Diese Szene bleibt; Änderungen ergeben eine neue.',
    redo: 'Wiederholen', reset: 'Von vorn', remake: 'Neu machen', remade: 'Der geänderte Raum entsteht.',
    no_room: 'Diese Szene stammt aus Bildern: es gibt keinen bekannten Raum zu ändern.',
    download: 'Herunterladen', on_demand: 'auf Wunsch', preparing: 'entsteht …', command: 'Dasselbe auf der Kommandozeile',
    copy: 'Kopieren', copied: 'Kopiert.', groups: { share: 'Zum Teilen', splats: 'Splats', room: 'Für Engines', data: 'Daten' },
    file: 'Datei', size: 'Größe', what_for: 'Wofür', shown_command: 'Befehl', lost: 'Diese Seite gibt es nicht.', lost_scene: 'Eine Szene dieses Namens gibt es nicht.',
    offline: 'Das Studio antwortet nicht. Läuft es noch? Was entsteht, geht beim nächsten Start weiter.',
    close: 'Schließen', facts: 'Angaben', made_in: 'entstanden in', peak: 'Speicherspitze', from: 'entstanden aus', walls_alt: 'Wand',
    saved_later: 'Deine Änderungen bleiben, bis du sie machst oder von vorn beginnst.', licenses: 'Lizenzen',
};

export const languages = { en: 'English', de: 'Deutsch' };
export type Language = keyof typeof languages;
const remembered = () => { try { return localStorage.getItem('language'); } catch { return null; } };
export const language: Language = ((remembered() ?? navigator.language).startsWith('de')) ? 'de' : 'en';
export const t = language === 'de' ? de : en;
export const speak = (to: Language) => {
    try { localStorage.setItem('language', to); } catch { /* private windows forget */ }
    location.reload();
};
export const fill = (text: string, ...values: (string | number)[]) =>
    text.replace(/\{(\d)\}/g, (_, i) => String(values[Number(i)]));

export const clock = (seconds: number) => {
    const s = Math.max(0, Math.round(seconds));
    return s >= 3600 ? `${Math.floor(s / 3600)}:${String(Math.floor(s / 60) % 60).padStart(2, '0')} h`
        : `${Math.floor(s / 60)}:${String(s % 60).padStart(2, '0')}`;
};
export const minutes = (seconds: number) =>
    seconds < 50 ? `${Math.round(seconds)} s` : `${new Intl.NumberFormat(language, { maximumFractionDigits: seconds < 300 ? 1 : 0 }).format(seconds / 60)} ${t.min}`;
export const size = (bytes: number) => {
    const f = (v: number) => new Intl.NumberFormat(language, { maximumFractionDigits: v < 10 ? 1 : 0 }).format(v);
    return bytes >= 1e9 ? `${f(bytes / 1e9)} GB` : bytes >= 1e6 ? `${f(bytes / 1e6)} MB` : `${f(bytes / 1e3)} KB`;
};
export const day = (seconds: number) =>
    new Intl.DateTimeFormat(language, { dateStyle: 'medium', timeStyle: 'short' }).format(new Date(seconds * 1000));
