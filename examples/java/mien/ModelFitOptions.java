package mien;

// Written by abi/generate_bindings.py.
/** mien_model_fit_options of the C interface. */
public final class ModelFitOptions implements Record_ {
    private int align;
    private double ridgeMm2;
    private Values weights;
    private int scalarModes;
    private int vectorModes;

    /** With the library's defaults. */
    public ModelFitOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(56);
            int offset = 0;
            Raw.GET.mien_model_fit_options_init(at.address, 56);
            align = at.bytes.getInt(offset + 4);
            ridgeMm2 = at.bytes.getDouble(offset + 8);
            scalarModes = at.bytes.getInt(offset + 48);
            vectorModes = at.bytes.getInt(offset + 52);
        }
    }

    /** 1: move the target rigidly onto the model's mean; default 0 */
    public ModelFitOptions align(int value) {
        align = value;
        return this;
    }
    public int align() { return align; }

    /** rho: variance of the target's noise, mm^2, &gt;= 0; default 1 */
    public ModelFitOptions ridgeMm2(double value) {
        ridgeMm2 = value;
        return this;
    }
    public double ridgeMm2() { return ridgeMm2; }

    /** one per vertex of the target, &gt;= 0, which enter squared; count 0: all one */
    public ModelFitOptions weights(Values value) {
        weights = value;
        return this;
    }
    public Values weights() { return weights; }

    /** the first of them, the others stay 0; -1 (default): all */
    public ModelFitOptions scalarModes(int value) {
        scalarModes = value;
        return this;
    }
    public int scalarModes() { return scalarModes; }

    /** the first of them, the others stay 0; -1 (default): all */
    public ModelFitOptions vectorModes(int value) {
        vectorModes = value;
        return this;
    }
    public int vectorModes() { return vectorModes; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_model_fit_options_init(at.address + offset, 56);
        at.bytes.putInt(offset + 4, align);
        at.bytes.putDouble(offset + 8, ridgeMm2);
        call.matrix(at, offset + 16, weights, 1, "weights");
        at.bytes.putInt(offset + 48, scalarModes);
        at.bytes.putInt(offset + 52, vectorModes);
    }
}
