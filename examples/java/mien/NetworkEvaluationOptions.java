package mien;

// Written by abi/generate_bindings.py.
/** What to evaluate; initialise with mien_network_evaluation_options_init(). */
public final class NetworkEvaluationOptions implements Record_ {
    private int neutralOnly;
    private int perceptual;
    private int[] subjects;

    /** With the library's defaults. */
    public NetworkEvaluationOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(56);
            int offset = 0;
            Raw.GET.mien_network_evaluation_options_init(at.address, 56);
            neutralOnly = at.bytes.getInt(offset + 4);
            perceptual = at.bytes.getInt(offset + 8);
        }
    }

    /** 1: only the faces marked neutral; default 0: all */
    public NetworkEvaluationOptions neutralOnly(int value) {
        neutralOnly = value;
        return this;
    }
    public int neutralOnly() { return neutralOnly; }

    /** 1 (default): DAME and FMPD too; 0: distances alone */
    public NetworkEvaluationOptions perceptual(int value) {
        perceptual = value;
        return this;
    }
    public int perceptual() { return perceptual; }

    /** faces of these subjects; null: of all */
    public NetworkEvaluationOptions subjects(int[] value) {
        subjects = value;
        return this;
    }
    public int[] subjects() { return subjects; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_network_evaluation_options_init(at.address + offset, 56);
        at.bytes.putInt(offset + 4, neutralOnly);
        at.bytes.putInt(offset + 8, perceptual);
        at.bytes.putLong(offset + 16, Memory.address(call.array(subjects)));
        at.bytes.putLong(offset + 24, call.rows(subjects, 1, "subjects"));
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(56);
        fill(call, at, 0);
        at.bytes.putLong(32, call.progressFunction(progress));
        at.bytes.putLong(40, call.progressUser());
        at.bytes.putLong(48, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}
